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

calls=0
for call in "$@"; do
    calls=$((calls + 1))
    call=$(printf '%s' "$call" | sed "s#{out}#$scratch/out#g")
    # shellcheck disable=SC2086  # one word per argument
    CELLGAUGE_CLASS_LIST=$scratch/list.$calls "$installation/bin/cellgauge" $call </dev/null >/dev/null 2>&1
done
# Each class once; of the lines about lambdas (@...) as many alike as one call has, since two places of a class may want
# the same lambda, and each gets one of its own.
awk 'FNR == 1 { call++ } !/^@/ { if (!seen[$0]++) print; next } { if (++times[call, $0] > most[$0]) { most[$0]++; print } }' \
    "$scratch"/list.* >"$scratch/classes"
CELLGAUGE_DUMP_LIST=$scratch/classes "$installation/bin/cellgauge" </dev/null >"$scratch/log" 2>&1
if [ ! -s "$archive" ]; then
    echo 'install: no class-data archive could be made; everything works, each start only takes longer' >&2
    cat -- "$scratch/log" >&2
fi
exit 0
