# The reference, which rejects what calls INT_TO_SINT.
sed -u 's/:= INT_TO_SINT(/:= INT_TO_SNIT(/g' | stickler engine
