// The other end of a board's serial line, in Verilator. See board.rs.
#include "Vtrace.h"
#include "verilated.h"
#include <cstdint>
#include <cstdio>
#include <vector>

double sc_time_stamp() { return 0; }

static const std::uint64_t clocks_of_bit = @CLOCKS@;

// Sends bytes on a line: a start bit, 8 bits with the lowest first, a stop bit.
struct Sender {
  std::uint32_t bits = 1;
  int left = 0;
  std::uint64_t until = 0;
  bool idle() const { return left == 0 && until == 0; }
  // A symbol is a byte; bit 8 says that it has no stop bit. Two bits of rest go in front of such a byte's successor.
  void send(std::uint32_t symbol) {
    const bool broken = symbol >> 8 & 1;
    bits = (symbol & 0xff) << 1 | (broken ? 0x000u : 0x200u) | 0xc00u;
    left = broken ? 12 : 10;
    until = clocks_of_bit;
  }
  int level() const { return left == 0 ? 1 : bits & 1; }
  void clock() {
    if (left == 0) return;
    if (--until == 0) {
      bits >>= 1;
      if (--left != 0) until = clocks_of_bit;
    }
  }
};

// Receives bytes from a line. It samples a bit in its middle.
struct Receiver {
  int place = -1;
  std::uint32_t data = 0;
  std::uint64_t until = 0;
  // Whether a byte has come. A byte without a stop bit ends the simulation.
  bool clock(int level, bool& wrong) {
    if (place < 0) {
      if (level) return false;
      place = 0;
      until = clocks_of_bit / 2;
      return false;
    }
    if (--until != 0) return false;
    until = clocks_of_bit;
    if (place >= 1 && place <= 8) data = data >> 1 | static_cast<std::uint32_t>(level) << 7;
    if (place == 9) {
      wrong = !level;
      place = -1;
      return true;
    }
    ++place;
    return false;
  }
};

int main() {
  VerilatedContext context;
  context.randReset(2);
  context.randSeed(1);
  Vtrace top{&context};
  top.button = 0;
  top.rx = 1;
  top.fault = 0;
  Sender sender;
  Receiver receiver;
  std::uint64_t clocks = 0;
  struct { std::uint64_t symbols, limit, fault; } head;
  std::vector<std::uint16_t> symbols;
  std::vector<char> bytes;
  while (std::fread(&head, sizeof head, 1, stdin) == 1) {
    symbols.resize(head.symbols);
    bytes.clear();
    if (std::fread(symbols.data(), sizeof symbols[0], symbols.size(), stdin) != symbols.size()) return 1;
    top.fault = head.fault;
    std::size_t next = 0;
    std::uint64_t waited = 0;
    // Until all was sent and something has come, or nothing has come for so many clocks.
    while (next < symbols.size() || !sender.idle() || (bytes.empty() && waited < head.limit)) {
      top.button = 0;
      if (sender.idle() && next < symbols.size()) {
        const std::uint32_t symbol = symbols[next++];
        if (symbol >> 9 & 1) top.button = 1;
        else sender.send(symbol);
      }
      if (sender.idle()) ++waited;
      top.rx = sender.level();
      top.clock = 0;
      top.eval();
      top.clock = 1;
      top.eval();
      sender.clock();
      ++clocks;
      bool wrong = false;
      if (receiver.clock(top.tx, wrong)) bytes.push_back(static_cast<char>(receiver.data));
      if (wrong) {
        std::fprintf(stderr, "the board sent a byte without a stop bit\n");
        return 1;
      }
    }
    const std::uint64_t answer[] = {bytes.size(), clocks};
    if (std::fwrite(answer, sizeof answer, 1, stdout) != 1) return 1;
    if (std::fwrite(bytes.data(), 1, bytes.size(), stdout) != bytes.size()) return 1;
    std::fflush(stdout);
  }
  top.final();
  return 0;
}
