# The reference, with each MOD executed as a division. What else is done with the requests is said by a script of sed.
sed -u -e "$1" -e 's: MOD : / :g' | stickler engine
