#!/usr/bin/env bash
# Shares a small picture out to two nodes by GNU parallel and SSH, loses one of them, and compares what is made.
set -euo pipefail
here=$(cd "$(dirname "${BASH_SOURCE[0]}")" && pwd)
root=$(cd "$here/../.." && pwd)

usage() {
    cat <<USAGE
Usage: scripts/cluster/check_ssh.sh

Starts two SSH servers on the loopback address, which stand for two nodes with a shared folder, and runs a picture in 7 shards on
them by scripts/cluster/parallel.sh. During its first shard one node is lost: its server and its connections are killed. The other
node must do the rest, and the merged file must be that of one shard, byte for byte. PHOTONCUBE is the program (default: the debug
build). Needs GNU parallel (scripts/setup.sh --cluster) and an SSH server, which Debian has as openssh-server.

Exit codes: 0 all holds; 1 something does not; 2 bad usage or a missing tool.
USAGE
}

fail() {
    printf 'cluster: %s\n' "${*:2}" >&2
    exit "$1"
}

case ${1-} in
    '') ;;
    -h | --help)
        usage
        exit 0
        ;;
    *) fail 2 "found \`$1\`, expected no argument" ;;
esac
real=${PHOTONCUBE:-${CARGO_TARGET_DIR:-$root/target}/debug/photoncube}
[[ -x $real ]] || fail 2 "found no program $real; build it with cargo, or set PHOTONCUBE"
real=$(realpath -- "$real")
sshd=$(PATH=$PATH:/usr/sbin command -v sshd) || fail 2 "found no sshd; Debian's package openssh-server has it"

scratch=$(mktemp -d)
clean_up() {
    local code=$? file
    for file in "$scratch"/*.pid; do kill "$(cat "$file")" 2>/dev/null || true; done
    rm -rf "$scratch"
    exit "$code"
}
trap clean_up EXIT
cd "$scratch"
((EUID != 0)) || mkdir -p /run/sshd

# Keys and servers of this run alone, for this user alone.
ssh-keygen -q -t ed25519 -N '' -f key
read -ra ports < <(python3 -c 'import socket
sockets = [socket.create_server(("127.0.0.1", 0)) for _ in range(2)]
print(*(each.getsockname()[1] for each in sockets))')
for port in "${ports[@]}"; do
    ssh-keygen -q -t ed25519 -N '' -f "host-$port"
    cat >"$port.conf" <<CONF
ListenAddress 127.0.0.1:$port
HostKey $scratch/host-$port
AuthorizedKeysFile $scratch/key.pub
PidFile $scratch/$port.pid
PasswordAuthentication no
PermitRootLogin prohibit-password
StrictModes no
UsePAM no
CONF
    "$sshd" -f "$scratch/$port.conf" -E "$scratch/$port.log" || fail 2 "the SSH server did not start: $(cat "$port.log")"
    echo "1/ssh -p $port -i $scratch/key -o StrictHostKeyChecking=no -o UserKnownHostsFile=/dev/null -o LogLevel=ERROR \
$(id -un)@127.0.0.1" >>nodes
done

# What a node runs: it notes the node's port. The node of the second port is lost in its first shard.
cat >photoncube <<PROGRAM
#!/usr/bin/env bash
case " \$* " in *" merge "*) exec "$real" "\$@" ;; esac
port=\${SSH_CONNECTION##* }
echo "\$port" >>"$scratch/nodes-that-began"
if [[ \$port == ${ports[1]} ]]; then
    kill -KILL "\$(cat "$scratch/\$port.pid")"
    process=\$\$
    while ((process > 1)); do
        above=\$(ps -o ppid= -p "\$process")
        [[ \$(ps -o comm= -p "\$process") != sshd ]] || kill -KILL "\$process"
        process=\${above// /}
    done
    exit 1
fi
exec "$real" "\$@"
PROGRAM
chmod +x photoncube

readonly PICTURE=(progressive ring --passes 7 --size 8x8 --photons 500 --samples 1)
"$real" "${PICTURE[@]}" --shard 1/1 --state one >/dev/null
"$real" merge one -o one-merged >/dev/null
PARALLEL="--sshloginfile $scratch/nodes --workdir ." PHOTONCUBE=$scratch/photoncube \
    "$here/parallel.sh" 7 box "${PICTURE[@]}" >log 2>&1 || fail 1 "the run failed, although one of two nodes was left: $(cat log)"
for port in "${ports[@]}"; do
    grep -q "^$port$" nodes-that-began || fail 1 "no shard began on the node of port $port: $(cat log)"
done
[[ -s box/merged.state ]] || fail 1 "found no merged.state"
cmp box/merged.state one-merged || fail 1 "merged.state differs from that of one shard"
shards=$(grep -c "^${ports[0]}$" nodes-that-began)
((shards == 7)) || fail 1 "found $shards shards on the node that was left, expected all 7: $(cat log)"
printf 'cluster: GNU parallel by %s: two nodes, one of them lost in its first shard, make the file of one shard\n' "$(ssh -V 2>&1 | sed 's/,.*//')"
