# The reference, with each MOD of a request replaced by a division.
sed -u 's: MOD : / :g' | stickler engine
