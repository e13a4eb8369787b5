#!/bin/sh
# class-archive.sh INSTALLATION 'ARGUMENTS OF A CALL'...
# Runs the calls, notes the classes they load, and writes those into lib/cellgauge.jsa (class-data sharing), from where a
# later start maps them instead of reading jars. A static archive: on JDK 17 a dynamic one leaves out picocli, whose class
# files are of an old version.
installation=$1
shift
archive=$installation/lib/cellgauge.jsa
scratch=$(mktemp -d) || exit 0
trap 'rm -rf -- "$scratch"' EXIT
rm -f -- "$archive"

for call in "$@"; do
    call=$(printf '%s' "$call" | sed "s#{out}#$scratch/out#g")
    # shellcheck disable=SC2086  # one word per argument
    CELLGAUGE_CLASS_LIST=$scratch/list "$installation/bin/cellgauge" $call </dev/null >/dev/null 2>&1
    cat -- "$scratch/list" >>"$scratch/all" 2>/dev/null
done
# Records name a class once; the lines about lambdas and call sites (@…) may come more than once too.
awk '!seen[$0]++' "$scratch/all" >"$scratch/classes"
CELLGAUGE_DUMP_LIST=$scratch/classes "$installation/bin/cellgauge" </dev/null >"$scratch/log" 2>&1
if [ ! -s "$archive" ]; then
    echo 'install: no class-data archive could be made; everything works, each start only takes longer' >&2
    cat -- "$scratch/log" >&2
fi
exit 0
