#!/bin/sh
# links_no_qt PROGRAM: fails when the program needs a Qt library.
needed=$(objdump -p "$1" | grep NEEDED) || exit 2
if echo "$needed" | grep -i qt; then
  echo "$1 needs Qt"
  exit 1
fi
