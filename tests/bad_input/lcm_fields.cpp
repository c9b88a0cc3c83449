#include "tests/bad_input/lcm_fields.hpp"

#include <fstream>
#include <map>
#include <sstream>
#include <stdexcept>

namespace quickstrip::test {
namespace {

constexpr std::size_t kFingerprintBytes = 8;

struct Declaration {
  std::string type;
  std::string name;
  std::size_t num_elements = 1;
};

// "double hs_m[6];  // ..." -> double, hs_m, 6. Nothing for other lines.
bool read_declaration(std::string line, Declaration& out) {
  line = line.substr(0, line.find("//"));
  const std::size_t end = line.find(';');
  if (end == std::string::npos || line.find("const ") != std::string::npos ||
      line.find("package ") != std::string::npos) {
    return false;
  }
  out = {};
  std::istringstream words(line.substr(0, end));
  std::string field;
  words >> out.type >> field;
  out.name = field.substr(0, field.find('['));
  for (std::size_t at = field.find('['); at != std::string::npos; at = field.find('[', at + 1)) {
    out.num_elements *= std::stoul(field.substr(at + 1));
  }
  return true;
}

std::size_t size_of(const std::string& type) {
  static const std::map<std::string, std::size_t> kSizes{{"int8_t", 1},  {"byte", 1},  {"int16_t", 2},
                                                         {"int32_t", 4}, {"float", 4}, {"int64_t", 8},
                                                         {"double", 8}};
  const auto found = kSizes.find(type);
  return found == kSizes.end() ? 0 : found->second;
}

/// Appends the fields of `type` that begin at `offset`; returns where they end.
std::size_t append_fields(const std::string& type, std::size_t offset, std::vector<LcmField>& out) {
  std::ifstream file(std::string(QUICKSTRIP_SOURCE_DIR) + "/msgs/" + type + ".lcm");
  if (!file) {
    throw std::runtime_error("no such type: " + type);
  }
  std::string line;
  Declaration field;
  while (std::getline(file, line)) {
    if (!read_declaration(line, field)) {
      continue;
    }
    if (const std::size_t size = size_of(field.type); size > 0) {
      out.push_back({field.name, field.type, offset, size, field.num_elements, size});
      offset += size * field.num_elements;
      continue;
    }
    for (std::size_t i = 0; i < field.num_elements; ++i) {  // another of our types
      std::vector<LcmField> inner;
      offset = append_fields(field.type, offset, inner);
      for (LcmField& each : inner) {
        each.name = field.name + "." + each.name;
        out.push_back(each);
      }
    }
  }
  return offset;
}

}  // namespace

std::vector<LcmField> lcm_fields(const std::string& type) {
  std::vector<LcmField> fields;
  append_fields(type, kFingerprintBytes, fields);
  return fields;
}

}  // namespace quickstrip::test
