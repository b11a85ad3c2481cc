# Runs the script of the action in a job of GitHub, with the inputs that are given as NAME=VALUE.
export GITHUB_ACTIONS=true GITHUB_STEP_SUMMARY="$PWD/summary" GITHUB_OUTPUT="$PWD/output"
exec env ENGINE= CONFIG= BASELINE= CASES="$SUITE" DIALECT= FILTER= SHARD= MERGE= REPORT= "$@" bash "$ROOT/.ci/action"
