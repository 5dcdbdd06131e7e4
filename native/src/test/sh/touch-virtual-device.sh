#!/bin/sh
# Runs palpate with a simulated hand-built device. The unmodified hidapi finds it as /dev/hidraw0 of
# umockdev. Its firmware is docs/firmware/palpate_device.c, and a hand moves it at 1 kHz.
#
#   native/src/test/sh/touch-virtual-device.sh [COMMAND [ARGUMENT ...]]
#
# Without arguments it runs touch --device hid --seconds 10 --headless. At the end the device prints
# statistics of the forces that it received. It needs umockdev libumockdev-dev libhidapi-hidraw0
# pkg-config cmake g++ (Debian's names).
set -eu
module=$(CDPATH='' cd -- "$(dirname -- "$0")/../../.." && pwd -P)
build=$module/target/cmake-tests
[ $# -gt 0 ] || set -- touch --device hid --seconds 10 --headless
cmake -S "$module" -B "$build" -DPALPATE_TESTS=ON -DPALPATE_JNI=OFF >/dev/null
case $(cmake --build "$build" --target help) in *umock_hid*) ;; *)
  echo "palpate: no umockdev: virtual device: apt-get install libumockdev-dev umockdev pkg-config" >&2
  exit 1 ;;
esac
cmake --build "$build" --target umock_hid >/dev/null
LD_PRELOAD=libumockdev-preload.so.0 exec "$build/umock_hid" "$module/../palpate" "$@"
