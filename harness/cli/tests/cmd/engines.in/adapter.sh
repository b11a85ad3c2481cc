# An adapter that writes down that it started and that it came to its own end.
echo started >> log
stickler engine
echo left >> log
