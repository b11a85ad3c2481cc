# Prints the events of a run without its times and its command.
sed -e 's/"started":"[^"]*","command":"[^"]*"//' -e 's/"duration_[mu]s":[0-9]*//' -e 's/^\(\[[0-9]*,"[^"]*"\),[0-9]*/\1/' "$1/events.jsonl"
