#!/usr/bin/env python3
"""Prints what the advisor says. Python's own library and the types by lcm-gen; no LCM library is needed:
LCM's udpm:// is a UDP multicast of "LC02", a sequence number, the channel's name with a NUL, and the message.
  lcm-gen --python --ppath DIRECTORY advice_t.lcm;  PYTHONPATH=DIRECTORY advice_subscriber.py [PORT [MESSAGES]]
"""
import socket
import struct
import sys
import time

from quickstrip import advice_t

GROUP = "239.255.76.67"
VERDICTS = {1: "good", 2: "caution", 3: "limits exceeded"}


def text(field):
    return bytes(field).split(b"\0")[0].decode("utf-8", "replace")


def messages(port):
    """Channel and bytes; what is larger than a datagram comes in pieces ("LC03"), which advice is not."""
    bus = socket.socket(socket.AF_INET, socket.SOCK_DGRAM)
    bus.setsockopt(socket.SOL_SOCKET, socket.SO_REUSEADDR, 1)
    bus.setsockopt(socket.SOL_SOCKET, socket.SO_REUSEPORT, 1)
    bus.bind((GROUP, port))
    bus.setsockopt(socket.IPPROTO_IP, socket.IP_ADD_MEMBERSHIP, struct.pack("=4sl", socket.inet_aton(GROUP), socket.INADDR_ANY))
    bus.settimeout(3.0)
    while True:
        try:
            packet = bus.recv(65536)
        except socket.timeout:
            yield None, b""
            continue
        if packet[:4] == b"LC02" and b"\0" in packet[8:]:
            channel, _, body = packet[8:].partition(b"\0")
            yield channel, body


def say(advice):
    if time.time() * 1e6 > advice.valid_until_utime:
        return f"advice {advice.seq} has come too late to be shown"
    if advice.no_advice != 0:
        return text(advice.no_advice_text)
    line = (f"{advice.heading_deg:03.0f} deg, {advice.speed_kn:.1f} kn: {VERDICTS.get(advice.verdict, 'not known')}; "
            f"governed by {text(advice.governing_name) or 'nothing'}, waves may grow by the factor {advice.margin:.2f}")
    return line + (f"\n  best change: {text(advice.change_text[0])}" if advice.num_changes > 0 else "")


def main():
    left = int(sys.argv[2]) if len(sys.argv) > 2 else -1
    for channel, body in messages(int(sys.argv[1]) if len(sys.argv) > 1 else 7667):
        if channel is None:
            print("No advice, because the advisor is silent", flush=True)
        elif channel == b"QS_ADVICE":
            try:
                advice = advice_t.decode(body)
            except (ValueError, struct.error):
                continue  # not of this type
            print(say(advice), flush=True)
            left -= 1
            if left == 0:
                return


if __name__ == "__main__":
    main()
