#include "firmware/nmea/reader.hpp"

#include <algorithm>

namespace quickstrip::nmea {
namespace {

bool is_talker(std::string_view word) {
  const auto is_letter_or_digit = [](char c) { return (c >= 'A' && c <= 'Z') || (c >= '0' && c <= '9'); };
  return word == "P" ||
         (word.size() == 2 && word[0] != 'P' && std::all_of(word.begin(), word.end(), is_letter_or_digit));
}

}  // namespace

bool TalkerList::set(std::string_view list) {
  StaticVector<Talker, kMaxTalkers> talkers;
  while (true) {  // each turn takes a word off the list
    const std::size_t comma = list.find(',');
    const std::string_view word = list.substr(0, comma);
    if (!is_talker(word)) {
      return false;
    }
    if (!talkers.push_back({{word[0], word.size() > 1 ? word[1] : '\0'}})) {
      return false;
    }
    if (comma == std::string_view::npos) {
      break;
    }
    list.remove_prefix(comma + 1);
  }
  talkers_ = talkers;
  return true;
}

std::size_t TalkerList::rank(std::string_view talker) const {
  const char first = talker.empty() ? '\0' : talker[0];
  const char second = talker.size() > 1 ? talker[1] : '\0';
  for (std::size_t i = 0; i < talkers_.size(); ++i) {
    if (talkers_[i].letters[0] == first && talkers_[i].letters[1] == second) {
      return i;
    }
  }
  return kMaxTalkers;
}

Fate Reader::read(std::string_view line, Readings& out, std::size_t& talker_rank) {
  out.clear();
  Cut cut;
  if (const Fate fate = cut_sentence(line, options_.allow_missing_checksum, cut); fate != Fate::kTaken) {
    return fate;
  }
  talker_rank = options_.talkers.rank(cut.talker);
  if (talker_rank == kMaxTalkers) {
    return Fate::kTalker;
  }
  const Fate fate = read_family(cut, out);
  for (Reading& reading : out) {
    const bool is_inverted = (reading.quantity == Quantity::kRoll && options_.invert_roll) ||
                             (reading.quantity == Quantity::kPitch && options_.invert_pitch) ||
                             (reading.quantity == Quantity::kHeave && options_.invert_heave);
    reading.value = is_inverted ? -reading.value : reading.value;
  }
  return fate;
}

Fate Reader::read_family(const Cut& cut, Readings& out) {
  if (cut.talker == "P") {
    if (cut.formatter == "SXN") {
      return read_psxn(cut, psxn_quality_, out);
    }
    return cut.formatter == "ASHR" ? read_pashr(cut, out) : Fate::kNotUsed;
  }
  struct Family {
    std::string_view formatter;
    Fate (*read)(const Cut&, Readings&);
  };
  static constexpr Family kFamilies[] = {{"HDT", read_hdt}, {"THS", read_ths}, {"ROT", read_rot},
                                         {"VTG", read_vtg}, {"VHW", read_vhw}, {"VBW", read_vbw},
                                         {"RMC", read_rmc}, {"GGA", read_gga}, {"XDR", read_xdr}};
  for (const Family& family : kFamilies) {
    if (family.formatter == cut.formatter) {
      return family.read(cut, out);
    }
  }
  if (cut.formatter == "DPT") {
    return read_dpt(cut, options_.transducer_depth_m, out);
  }
  return cut.formatter == "DBT" ? read_dbt(cut, options_.transducer_depth_m, out) : Fate::kNotUsed;
}

}  // namespace quickstrip::nmea
