# Prints the events of a run without its times and its command.
gzip -dc "$1/events.jsonl.gz" | sed -e 's/"started":"[^"]*","command":"[^"]*"//' -e 's/"duration_[mu]s":[0-9]*//' -e 's/^\(\[[0-9]*,"[^"]*"\),[0-9]*/\1/'
