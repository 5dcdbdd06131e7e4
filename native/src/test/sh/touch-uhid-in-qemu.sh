#!/bin/sh
# Runs palpate with a hand-built device that the Linux kernel itself simulates (uhid), in a virtual
# machine without a disk. The machine runs Debian's kernel with this system's files, read-only. It is
# emulated in software, so its times mean nothing. The firmware is docs/firmware/palpate_device.c.
#
#   native/src/test/sh/touch-uhid-in-qemu.sh [COMMAND [ARGUMENT ...]]
#
# COMMAND starts palpate; by default it is that of this checkout. Its arguments follow. The script
# prints the output of the machine. It exits with 0 if three things hold. The device was listed.
# Without permission it was refused, with the udev rule to install. A session sent forces, none
# beyond the maximum and none at the end.
#
# It needs qemu-system-x86 busybox-static libhidapi-hidraw0 cmake g++ (Debian's names). It downloads
# Debian's kernel (70 MB) into target/qemu, unless PALPATE_KERNEL names a folder with vmlinuz and
# *.ko. It needs neither root nor KVM.
set -eu
module=$(CDPATH='' cd -- "$(dirname -- "$0")/../../.." && pwd -P)
build=$module/target/cmake-tests
kept=$module/target/qemu
work=
trap 'rm -rf "$work"' EXIT
trap 'exit 1' HUP INT TERM

# In the order of loading. Later kernels have merged or removed some of them.
modules="virtio_ring virtio virtio_pci_legacy_dev virtio_pci_modern_dev virtio_pci netfs fscache
  9pnet 9pnet_virtio 9p hid hid-generic uhid"

fail() {
  echo "palpate: $1" >&2
  exit 1
}

see_what_is_missing() {
  missing=
  command -v qemu-system-x86_64 >/dev/null || missing="$missing qemu-system-x86"
  busybox=$(command -v busybox || true)
  [ -n "$busybox" ] && "$busybox" --list | grep -qx insmod || missing="$missing busybox-static"
  command -v cmake >/dev/null || missing="$missing cmake"
  command -v c++ >/dev/null || missing="$missing g++"
  command -v setpriv >/dev/null || missing="$missing util-linux"
}

install_missing() {
  see_what_is_missing
  [ -n "$missing" ] || return 0
  how="apt-get install --no-install-recommends$missing"
  if [ "$(id -u)" -eq 0 ] && command -v apt-get >/dev/null; then
    echo "palpate: installing with apt-get:$missing" >&2
    # Names of packages are words without spaces.
    # shellcheck disable=SC2086
    DEBIAN_FRONTEND=noninteractive apt-get install -y -qq --no-install-recommends $missing \
      >"$work/apt.log" 2>&1 || { tail -n 5 "$work/apt.log" >&2; fail "cannot install: virtual machine: $how"; }
  else
    fail "programs are missing:$missing: run $how"
  fi
}

# Sets kernel to a folder with a kernel's package, unpacked.
find_kernel() {
  kernel=${PALPATE_KERNEL:-$kept}
  [ -z "$(find "$kernel" -name 'uhid.ko*' 2>/dev/null)" ] || return 0
  name=$(apt-cache depends linux-image-amd64 2>/dev/null |
    sed -n 's/^ *Depends: \(linux-image-[0-9].*\)/\1/p' | head -n 1)
  [ -n "$name" ] || fail "no kernel to run: PALPATE_KERNEL: name a folder with vmlinuz, uhid.ko and 9p.ko"
  echo "palpate: fetching $name" >&2
  mkdir -p "$kept"
  (cd "$work" && apt-get download -qq "$name" 2>/dev/null && dpkg -x "$name"_*.deb unpacked) ||
    fail "cannot fetch: $name: run apt-get update, then this again"
  for name in $modules; do
    find "$work/unpacked" -name "$name.ko*" -exec cp {} "$kept" \;
  done
  cp "$work/unpacked/boot/vmlinuz"* "$kept"
}

# Unpacks a module of the kernel into the first file system.
put_module() {
  file=$(find "$kernel" -name "$1.ko*" | head -n 1)
  case $file in
    '') ;;
    *.xz) xz -dc "$file" >"$root/modules/$1.ko" ;;
    *.zst) zstd -qdc "$file" >"$root/modules/$1.ko" ;;
    *) cp "$file" "$root/modules/$1.ko" ;;
  esac
}

# Makes the first file system: busybox, the modules and the script that starts the machine.
make_first_files() {
  root=$work/root
  mkdir -p "$root/bin" "$root/modules" "$root/host" "$root/proc" "$root/sys" "$root/dev"
  cp "$busybox" "$root/bin/busybox"
  for name in $modules; do put_module "$name"; done
  cat >"$root/init" <<INIT
#!/bin/busybox sh
export PATH=/bin
/bin/busybox --install -s /bin
for name in $(echo $modules); do
  [ ! -f /modules/\$name.ko ] || insmod /modules/\$name.ko
done
mount -t 9p -o trans=virtio,version=9p2000.L,ro,cache=loose,msize=524288 host /host
mount -t proc proc /host/proc
mount -t sysfs sys /host/sys
mount -t devtmpfs dev /host/dev
mount -t tmpfs tmp /host/run
cp /session /host/run/session
ip link set lo up
chroot /host /bin/sh /run/session 2>&1 | cat
poweroff -f
INIT
  chmod +x "$root/init"
}

quoted() {
  for word in "$@"; do
    printf " '%s'" "$(printf '%s' "$word" | sed "s/'/'\\\\''/g")"
  done
}

# Writes the script that runs in the machine once this system's files are mounted.
make_session() {
  cat >"$root/session" <<SESSION
export PATH=/usr/sbin:/usr/bin:/sbin:/bin HOME=/run LC_ALL=C.UTF-8 JAVA_HOME='${JAVA_HOME:-}'
export JDK_JAVA_OPTIONS=-Djava.io.tmpdir=/run
[ -n "\$JAVA_HOME" ] || unset JAVA_HOME
cd '$PWD'
echo "kernel \$(uname -r)"
cat >/run/steps <<'STEPS'
$(quoted "$@") devices
chown 65534 /dev/hidraw0
setpriv --bounding-set=-dac_override $(quoted "$@") devices
chown 0 /dev/hidraw0
$(quoted "$@") touch --device hid:SN0001 --phantom sphere:64 --seconds 6 --headless
STEPS
'$build/uhid_hid' /bin/sh /run/steps
echo "exit \$?"
SESSION
}

run_machine() {
  (cd "$root" && find . | "$busybox" cpio -o -H newc 2>/dev/null | gzip -1 >"$work/first.gz")
  # One thread for both processors: with two, a JVM sometimes runs code that it has only half patched.
  image=$(find "$kernel" -name 'vmlinuz*' -type f | head -n 1)
  timeout 600 qemu-system-x86_64 -accel tcg,thread=single -cpu max -smp 2 -m 1536 -display none \
    -no-reboot -nodefaults -serial stdio -monitor none \
    -kernel "$image" -initrd "$work/first.gz" -append "console=ttyS0 loglevel=1 panic=-1 mitigations=off" \
    -virtfs local,path=/,mount_tag=host,security_model=none,readonly=on,multidevs=remap \
    2>"$work/qemu.log" </dev/null | sed -u 's/\r//g' | tee "$work/said"
}

# Fails unless the machine printed a line of this form.
must_say() {
  grep -qE -- "$1" "$work/said" || fail "the session in the virtual machine: $2: look at what it said above"
}

check() {
  if ! grep -q '^kernel ' "$work/said"; then
    tail -n 5 "$work/qemu.log" >&2
    fail "the virtual machine does not start: qemu-system-x86_64: look at what it said above"
  fi
  must_say 'SN0001  Virtual hand-built device$' "the device was not listed"
  must_say 'udev/rules.d.*idVendor}=="1209"' "no permission was not answered with the udev rule"
  must_say '^exit 0$' "it failed"
  felt=$(grep '^uhid_hid: ' "$work/said") || fail "the device said nothing"
  forces=$(echo "$felt" | sed -n 's/.* \([0-9]*\) forces,.*/\1/p')
  pushes=$(echo "$felt" | sed -n 's/.* \([0-9]*\) with a push.*/\1/p')
  largest=$(echo "$felt" | sed -n 's/.* largest \([0-9]*\) mN.*/\1/p')
  last=$(echo "$felt" | sed -n 's/.* \([0-9]*\) mN at the end$/\1/p')
  [ "$forces" -gt 0 ] && [ "$pushes" -gt 0 ] || fail "nothing was felt: $felt"
  [ "$largest" -le 6000 ] || fail "more force than the device bears: $felt"
  [ "$last" -eq 0 ] || fail "the force stays on: $felt"
}

mkdir -p "$module/target"
work=$(mktemp -d "$module/target/qemu-XXXXXX")
install_missing
find_kernel
if [ $# -eq 0 ]; then
  "$module/../palpate" --version >/dev/null
  set -- "$module/../palpate"
fi
cmake -S "$module" -B "$build" -DPALPATE_TESTS=ON -DPALPATE_JNI=OFF >/dev/null
cmake --build "$build" --target uhid_hid >/dev/null
make_first_files
make_session "$@"
run_machine
check
echo "uhid in qemu: listed, refused, touched"
