#!/bin/sh
# Prints where the tools stand that make an APK, one "name=path" a line; the only place that looks for them.
#
# They are the newest complete build tools of the Android SDK that ANDROID_HOME or ANDROID_SDK_ROOT names, else what the
# PATH has (Debian's packages aapt, apksigner, zipalign and dexdump). Where neither is complete: one message on standard
# error, and exit code 1.

tools='aapt2 zipalign apksigner dexdump'

# Prints the tools in folder $1, or fails at the first that is missing.
in_folder() {
    for tool in $tools; do
        [ -x "$1/$tool" ] || return 1
    done
    for tool in $tools; do
        printf '%s=%s\n' "$tool" "$1/$tool"
    done
}

looked=
for sdk in "${ANDROID_HOME:-}" "${ANDROID_SDK_ROOT:-}"; do
    [ -n "$sdk" ] || continue
    # By number, not by letter: 9.0.0 < 34.0.0 < 35.0.0-rc1 < 35.0.0. Newest first.
    for version in $(ls "$sdk/build-tools" 2>/dev/null | grep '^[0-9]' |
            awk -F '[.-]' '{printf "%06d.%06d.%06d.%d.%s\t%s\n", $1, $2, $3, !/-/, $0, $0}' | sort -r | cut -f 2); do
        in_folder "$sdk/build-tools/$version" && exit 0
    done
    looked="$looked $sdk/build-tools"
done

found=
missing=
for tool in $tools; do
    path=$(command -v "$tool") || missing="$missing $tool"
    found="$found$tool=$path
"
done
if [ -z "$missing" ]; then
    printf '%s' "$found"
    exit 0
fi
printf '%s\n' "the Android build tools are incomplete: no$missing on the PATH${looked:+, no complete set under$looked}.\
 Install them (Debian, Ubuntu: apt-get install aapt apksigner zipalign dexdump), or set ANDROID_HOME to an Android SDK\
 with build tools." >&2
exit 1
