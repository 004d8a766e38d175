// Drives a core in Verilator. See core.rs.
#include "Vtrace.h"
#include "verilated.h"
#include <cstdint>
#include <cstdio>
#include <cstring>
#include <vector>

double sc_time_stamp() { return 0; }

static const std::uint64_t photon_bytes = @PHOTON_BYTES@, query_bytes = @QUERY_BYTES@, result_bytes = @RESULT_BYTES@;
static const std::uint32_t counters[] = {@COUNTERS@};

// A port of any width has its words in the order of their bits.
template <class T> static inline void set(T& port, const char* from, std::size_t bytes) { std::memcpy(&port, from, bytes); }
template <class T> static inline void get(const T& port, char* to, std::size_t bytes) { std::memcpy(to, &port, bytes); }

static inline void rise(Vtrace& top) {
  top.aclk = 1;
  top.eval();
}

static inline void fall(Vtrace& top) {
  top.aclk = 0;
  top.eval();
}

static void write_register(Vtrace& top, std::uint32_t address, std::uint32_t word) {
  top.s_axi_awaddr = address;
  top.s_axi_awvalid = 1;
  top.s_axi_wdata = word;
  top.s_axi_wstrb = 15;
  top.s_axi_wvalid = 1;
  top.s_axi_bready = 1;
  fall(top);
  while (!top.s_axi_awready) {
    rise(top);
    fall(top);
  }
  rise(top);
  top.s_axi_awvalid = 0;
  top.s_axi_wvalid = 0;
  fall(top);
  while (!top.s_axi_bvalid) {
    rise(top);
    fall(top);
  }
  rise(top);
}

static std::uint32_t read_register(Vtrace& top, std::uint32_t address) {
  top.s_axi_araddr = address;
  top.s_axi_arvalid = 1;
  top.s_axi_rready = 1;
  fall(top);
  while (!top.s_axi_arready) {
    rise(top);
    fall(top);
  }
  rise(top);
  top.s_axi_arvalid = 0;
  fall(top);
  while (!top.s_axi_rvalid) {
    rise(top);
    fall(top);
  }
  const std::uint32_t word = top.s_axi_rdata;
  rise(top);
  return word;
}

int main() {
  VerilatedContext context;
  context.randReset(2);
  context.randSeed(1);
  Vtrace top{&context};
@IDLE@  fall(top);
  rise(top);
  top.aresetn = 1;
  std::vector<char> in, out;
  std::uint64_t counts[4];
  while (std::fread(counts, sizeof counts, 1, stdin) == 1) {
    const std::uint64_t photons = counts[0], queries = counts[1], wanted = counts[2];
    std::vector<std::uint32_t> registers(2 * counts[3]);
    if (std::fread(registers.data(), 4, registers.size(), stdin) != registers.size()) return 1;
    for (std::size_t place = 0; place < registers.size(); place += 2) write_register(top, registers[place], registers[place + 1]);
    in.resize(photons * (photon_bytes + 2) + queries * (query_bytes + 2));
    out.resize(wanted * (result_bytes + 3));
    if (std::fread(in.data(), 1, in.size(), stdin) != in.size()) return 1;
    const char* photon = in.data();
    const char* query = photon + photons * (photon_bytes + 2);
    char* to = out.data();
    write_register(top, @CONTROL@, @CLEAR@);
    std::uint64_t photon_at = 0, query_at = 0, results = 0, still = 0;
    bool new_photon = true, new_query = true;
    top.m_axis_results_tready = 1;
    while (results < wanted && still < @SILENT@) {
      if (new_photon && photon_at < photons) {
        set(top.s_axis_photons_tdata, photon, photon_bytes);
        top.s_axis_photons_tlast = photon[photon_bytes];
        top.s_axis_photons_tdest = photon[photon_bytes + 1];
        photon += photon_bytes + 2;
      }
      if (new_query && query_at < queries) {
        set(top.s_axis_queries_tdata, query, query_bytes);
        top.s_axis_queries_tlast = query[query_bytes];
        top.s_axis_queries_tdest = query[query_bytes + 1];
        query += query_bytes + 2;
      }
      top.s_axis_photons_tvalid = photon_at < photons;
      top.s_axis_queries_tvalid = query_at < queries;
      fall(top);
      new_photon = top.s_axis_photons_tvalid && top.s_axis_photons_tready;
      new_query = top.s_axis_queries_tvalid && top.s_axis_queries_tready;
      ++still;
      if (new_photon) { ++photon_at; still = 0; }
      if (new_query) { ++query_at; still = 0; }
      if (top.m_axis_results_tvalid) {
        get(top.m_axis_results_tdata, to, result_bytes);
        to += result_bytes;
        *to++ = top.m_axis_results_tlast;
        *to++ = top.m_axis_results_tid;
        *to++ = top.m_axis_results_tuser;
        ++results;
        still = 0;
      }
      rise(top);
    }
    top.s_axis_photons_tvalid = 0;
    top.s_axis_queries_tvalid = 0;
    top.m_axis_results_tready = 0;
    if (std::fwrite(&results, sizeof results, 1, stdout) != 1) return 1;
    const std::size_t size = results * (result_bytes + 3);
    if (std::fwrite(out.data(), 1, size, stdout) != size) return 1;
    for (const std::uint32_t address : counters) {
      const std::uint64_t low = read_register(top, address);
      const std::uint64_t counter = low | std::uint64_t{read_register(top, address + 4)} << 32;
      if (std::fwrite(&counter, sizeof counter, 1, stdout) != 1) return 1;
    }
    std::fflush(stdout);
    if (results < wanted) return 1;
  }
  top.final();
  return 0;
}
