#!/bin/sh
# What reaching hidapi from Java costs: ours, JNA direct, hid4java, on one substitute library, by JMH.
#
#   benchmarks/src/test/sh/crossing-table.sh [JMH OPTION ...]
#
# Needs what ./palpate test has built: native/target/cmake-tests and the classes of the modules.
set -eu
root=$(CDPATH='' cd -- "$(dirname -- "$0")/../../../.." && pwd -P)
substitutes=$root/native/target/cmake-tests/substitutes
classes=$root/benchmarks/target
[ -f "$substitutes/libhidapi-hidraw.so.0" ] && [ -d "$classes/test-classes" ] || {
  echo "palpate: not built yet: $root: run ./palpate test once" >&2
  exit 1
}
ln -sf libhidapi-hidraw.so.0 "$substitutes/libhidapi-hidraw.so"
ln -sf libhidapi-hidraw.so.0 "$substitutes/libhidapi.so"
(cd "$root" && mvn -q -B -o -pl core,native,plugin,benchmarks test-compile \
  -Dpalpate.skipCpp=true org.apache.maven.plugins:maven-dependency-plugin:3.6.1:build-classpath \
  -Dmdep.outputFile=target/test-classpath -Dmdep.includeScope=test) >&2
PALPATE_NULL_HID=1 PALPATE_FAKE_HID=/nonexistent LD_LIBRARY_PATH=$substitutes \
  exec "${JAVA_HOME:-/usr}/bin/java" -Djna.library.path="$substitutes" \
  -cp "$classes/test-classes:$classes/classes:$(cat "$classes/test-classpath")" \
  org.openjdk.jmh.Main HidPeersBenchmark -jvmArgsAppend "-Djna.library.path=$substitutes" "$@"
