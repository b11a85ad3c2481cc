# An engine with IronPLC's name, which says that it has the version in $1. It gives 4 for two and two.
stickler engine | sed -u -e 's/"name":"reference"/"name":"ironplc"/' -e 's/"version":"[^"]*"/"version":"'"$1"'"/'
