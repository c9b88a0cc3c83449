#!/bin/bash
# On the machine that run boots: the five steps, then each unit looked at, fed, killed, stopped. A line each. Times are
# those of an emulated processor: tests/faults has what is promised.
cd /root || exit 1
failed=0
ok() { # ok WHAT COMMAND...: yes when the command succeeds
  local what=$1
  shift
  if "$@" >/tmp/said 2>&1; then
    echo "yes: $what"
  else
    echo "NO: $what"
    sed 's/^/  /' /tmp/said
    journalctl -q -o cat -n 12 -u 'quickstrip-*' | sed 's/^/  journal: /'
    failed=1
  fi
}
until_ok() { # until_ok SECONDS COMMAND...: so many, of a processor that is not emulated
  local end=$((SECONDS + $1 * patience))
  shift
  while ! "$@"; do
    ((SECONDS < end)) || return 1
    sleep 0.1
  done
}
sudo() { "$@"; } # the machine's only user is root
step() { # step N: the commands of README's step N
  awk -v n="$1" '$0 ~ "^\\*\\*" n "\\." { here = 1 } here && /^```$/ { exit } here && inside { print } here && /^```sh$/ { inside = 1 }' five_steps.md
}
does_step() { step "$1" | grep . >commands && bash -e commands; }
export -f sudo
says() { journalctl -q -u "quickstrip-$1" | grep -qF "$2"; }
pid_of() { systemctl show -P MainPID "quickstrip-$1"; }
status_of() { awk -v key="$2:" '$1 == key { print $2 }' "/proc/$(pid_of "$1")/status"; }
restarts() { [ "$(systemctl show -P NRestarts quickstrip-advisor)" = "$1" ] && systemctl is-active -q quickstrip-advisor; }
advises() { systemctl show -P StatusText quickstrip-advisor | tee /dev/stderr | grep -q '^advice: '; } # it tells systemd each change of verdict
page_comes() {
  exec 3<>/dev/tcp/127.0.0.1/8042 || return
  printf 'GET / HTTP/1.1\r\nHost: 127.0.0.1:8042\r\nConnection: close\r\n\r\n' >&3
  timeout 5 head -n 1 <&3 | tee /dev/stderr | grep -q ' 200 '
}

# Where the processor is emulated a cycle takes seconds, some of which pass without a word to the watchdog: it waits longer there.
patience=1
if [ "$(systemd-detect-virt)" = qemu ]; then
  patience=4
  mkdir -p /etc/systemd/system/quickstrip-advisor.service.d
  printf '[Service]\nWatchdogSec=%d\n' $((5 * patience)) >/etc/systemd/system/quickstrip-advisor.service.d/emulated.conf
  echo "  the processor is emulated: the watchdog waits $((5 * patience)) s instead of the unit's 5"
fi

for n in 1 2 3 4; do
  ok "step $n of README" does_step "$n"
done
advisor=quickstrip-advisor
ok "units run" until_ok 10 systemctl is-active $advisor quickstrip-display quickstrip-recorder
ok "self-test passed" until_ok 10 says advisor "self-test: passed"
ok "memory is locked" says advisor "memory is locked"
ok "the cycle runs in real time" says advisor "the cycle runs at SCHED_FIFO 50"
ok "a thread of it has that priority" sh -c "ps -L -o cls,rtprio -p $(pid_of advisor) | grep -q 'FF *50'"
ok "all of its memory is there: $(status_of advisor VmSize) kB, locked $(status_of advisor VmLck), resident $(status_of advisor VmRSS)" \
  [ "$(status_of advisor VmLck)" -ge $(($(status_of advisor VmSize) * 9 / 10)) ]
ok "user quickstrip" [ "$(ps -o user:20= -p "$(pid_of advisor)")" = quickstrip ]
ok "no capability" [ "$(status_of advisor CapEff)" = 0000000000000000 ]
ok "system calls filtered" [ "$(status_of advisor Seccomp)" = 2 ]
ok "no advice, and why" until_ok 5 says advisor "No advice, because"
ok "the display's page comes" until_ok 10 page_comes

# A storm from now on, an hour of hers each 20 s, as tests/soak/run does it.
start=$(($(date +%s) + 30)) # until then the log is made
awk -v start="$start" 'NR <= 3 { print; next }
  /^hour/ { n++; if (n > 0) { $2 = strftime("%Y-%m-%dT%H:%M:%SZ", start + (n - 1) * 20, 1) } }
  n > 0 { print }' /usr/share/quickstrip/storms/dorian_41010.sea >now.sea
cat >now.voyage.toml <<VOYAGE
schema = 1
name = "now"
end_utc = $(date -u -d "@$((start + 300))" +%Y-%m-%dT%H:%M:%SZ)
[[leg]]
from_utc = $(date -u -d "@$start" +%Y-%m-%dT%H:%M:%SZ)
heading_deg = 30.0
speed_kn = 12.0
VOYAGE
quickstrip-sim log --sea now.sea --voyage now.voyage.toml --own-ship-period-s 0.7 --out now.in >/dev/null 2>&1
sleep $((start - $(date +%s)))
quickstrip-sim replay now.in --publish --speed 1 >/dev/null 2>&1 &
feeder=$!
ok "fed, it advises" until_ok 15 advises

kill -9 "$(pid_of advisor)"
ok "killed, it runs again" until_ok 20 restarts 1
ok "and advises" until_ok 10 advises
kill -STOP "$(pid_of advisor)"
ok "stopped, the watchdog begins it again" until_ok 15 restarts 2
ok "and it advises" until_ok 10 advises
ok "the recorder has written" sh -c 'find /var/lib/quickstrip -name "*.lcmlog*" -o -name "*.log" -size +1k | grep -q .'
ok "its memory is within the unit's limit" sh -c \
  "[ \$(systemctl show -P MemoryCurrent $advisor) -lt \$(systemctl show -P MemoryMax $advisor) ]"
kill $feeder
ok "it stops when asked to" systemctl stop $advisor
ok "and says how it went" until_ok 10 says advisor "within a cycle the processor was given up 0 times"
echo "  $(journalctl -q -o cat -u $advisor | grep 'within a cycle' | tail -n 1)"
printf 'hul = "x"\n' >>/etc/quickstrip/advisor.toml
systemctl start $advisor >/dev/null 2>&1
ok "a wrong name in the configuration: it does not start, and says which" until_ok 5 says advisor "hul"
ok "removed, nothing of it runs" sh -c 'apt-get purge -y quickstrip && ! pgrep quickstrip- && [ ! -e /etc/quickstrip/advisor.toml ]'
[ $failed = 0 ] && echo "on board: as it should be"
[ $failed = 0 ] || echo "on board: NOT as it should be"
