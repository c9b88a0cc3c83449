// The programs on bad input: exit 1 and one line for bad files, exit 2 for wrong use, nothing on standard
// output, no file half written; and what `check` passes the advisor loads.
#include <array>
#include <memory>

#include "firmware/session/session.hpp"
#include "msgs/files/ship_files.hpp"
#include "tests/bad_input/edited_text.hpp"
#include "tests/bad_input/programs.hpp"

namespace quickstrip::test {
namespace {

TEST_F(Programs, BadFilesExitOneWithOneLineAndLeaveNothingBehind) {
  const std::string storm = kSource + "/sim/storms/swell_day_41010.sea";
  const std::string bad = folder_.file("bad.toml", "schema = 1\n");
  const std::string text = folder_.file("text.log", "this is no log");
  const std::string empty = folder_.file("empty.log", "");
  const std::string voyage =
      folder_.file("long.toml",
                   "schema = 1\nname = \"a century\"\nend_utc = 2099-09-02T06:00:00Z\n[[leg]]\nfrom_utc = "
                   "1999-09-02T00:00:00Z\nheading_deg = 0\nspeed_kn = 1\n");
  expect_bad(kHull + " check none.toml", {"none.toml: no such file"});
  expect_bad(kHull + " check .", {".: a folder"});
  expect_bad(kHull + " check bad.toml", {"bad.toml: name: missing"});
  expect_bad(kHull + " grid " + kS175 + " --sea none.sea", {"none.sea: no such file"});
  expect_bad(kHull + " grid " + kS175 + " --sea bad.toml", {"bad.toml:1: title = schema = 1"});
  expect_bad(kHull + " grid " + kS175 + " --sea ndbc:./none", {"nonew*: files = 0"});
  expect_bad(kHull + " grid " + kS175 + " --sea " + storm + " --at 2030-01-01T00:00Z",
             {"--at = 2030", "90 minutes"});
  expect_bad(kHull + " hydrostatics " + kS175 + " --draught-aft-m 0.001 --draught-fwd-m 0.001",
             {"--draught-aft-m"});
  const std::string sea = " --spectrum bretschneider --hs-m 3 --t1-s 9 --speed-kn 10 --mu-deg 90";
  expect_bad(kHull + " responses " + kS175 + sea + " --point 300,0,35",
             {"--point 300,0,35: x = 300", "-10.4125 to 183.75 m"});
  expect_bad(kHull + " responses " + kS175 + sea + " --point 30,16,35",
             {"--point 30,16,35: y = 16", "-15.24 to 15.24 m to port"});
  const std::string low = folder_.file(
      "low.toml", edited(source_text("sim/hulls/s175.hull.toml"), "height_m = 16.0", "height_m = 9.8"));
  expect_bad(kHull + " responses low.toml" + sea + " --draught-aft-m 10 --draught-fwd-m 10",
             {"low.toml: freeboard \"bow\": height_m = 9.8", "waterline there, 10 m"});
  expect_bad(kSim + " log --sea none --voyage bad.toml --out o.log", {"none: no such file"});
  expect_bad(kSim + " log --sea " + storm + " --voyage bad.toml --out o.log", {"bad.toml: name: missing"});
  expect_bad(kSim + " log --sea " + storm + " --voyage long.toml --out o.log",
             {"a century", "36525 days", "at most"});
  expect_bad(kSim + " log --sea " + storm + " --voyage " + kSource +
                 "/sim/voyages/dorian_passage.voyage.toml --out none/o.log",
             {"none/o.log: cannot be written"});
  expect_bad(kSim + " replay none.log --hull " + kS175, {"none.log: no such file"});
  expect_bad(kSim + " replay text.log --hull " + kS175 + " --out o.log --csv o.csv",
             {"text.log: offset 0", "EDA1DA01"});
  expect_bad(kSim + " replay empty.log --hull bad.toml --out o.log", {"bad.toml: name: missing"});
  expect_bad(kSim + " replay empty.log --hull " + kS175 + " --out none/o.log",
             {"none/o.log: cannot be written"});
  expect_bad(kSim + " replay empty.log --hull " + kS175 + " --out o.log --csv none/o.csv",
             {"none/o.csv: cannot be"});
  expect_bad(kSim + " inspect text.log", {"text.log: offset 0"});
  expect_bad(kSim + " story empty.log", {"empty.log: holds no advice"});
  expect_bad(kSim + " picture empty.log --out o.png", {"empty.log: holds no advice"});
  expect_bad(kHull + " check " + kS175 + " --limits bad.toml", {"bad.toml: name: missing"});
  expect_bad(kAdvisor + " --hull none.toml", {"none.toml: no such file"});
  expect_bad(kAdvisor + " --hull bad.toml", {"bad.toml: name: missing"});
  expect_bad(kAdvisor + " --hull " + kS175 + " --limits bad.toml", {"bad.toml: name: missing"});
  expect_bad(kAdvisor + " --hull " + kS175 + " --state text.log --url memq://", {"text.log: offset 0"});
}

TEST_F(Programs, ImpossibleOptionsExitTwoNamingOptionValueAndRange) {
  const std::string sea = " --spectrum bretschneider --hs-m 3 --t1-s 9 --speed-kn 10";
  const std::string responses = kHull + " responses " + kS175;
  const std::string motions = kHull + " motions " + kS175 + " --speed-kn 10";
  expect_wrong_use(responses + " --mu-deg 90 --spectrum bretschneider --speed-kn 10 --t1-s 9 --hs-m 40",
                   {"--hs-m: 40", "0.01 ... 30"});
  expect_wrong_use(responses + " --mu-deg 90 --spectrum bretschneider --speed-kn 10 --t1-s 9 --hs-m nan",
                   {"--hs-m: nan"});
  expect_wrong_use(responses + " --mu-deg 90 --spectrum bretschneider --speed-kn 10 --hs-m 3 --t1-s 0",
                   {"--t1-s: 0", "1 ... 40"});
  expect_wrong_use(kAdvisor + " --hull " + kS175 + " --author 'a name that is longer than the logbook'",
                   {"--author", "at most 31 bytes"});
  expect_wrong_use(responses + sea + " --mu-deg 725", {"--mu-deg: 725", "above -360 ... 360"});
  expect_wrong_use(responses + sea + " --mu-deg -360", {"--mu-deg: -360", "above -360"});
  expect_wrong_use(responses + sea + " --mu-deg 0:10:0", {"--mu-deg: 0:10:0", "a step that leads"});
  expect_wrong_use(responses + sea + " --mu-deg 10:0:1", {"--mu-deg: 10:0:1", "a step that leads"});
  expect_wrong_use(responses + sea + " --mu-deg 0:1:1e-7", {"--mu-deg: 0:1:1e-7", "at most 10000 values"});
  expect_wrong_use(responses + sea + " --mu-deg 90 --spreading-deg 90", {"--spreading-deg: 90", "0 ... 80"});
  expect_wrong_use(responses + sea + " --mu-deg 90 --roll-damping-ratio nan", {"--roll-damping-ratio: nan"});
  expect_wrong_use(responses + sea + " --mu-deg 90 --swell-up 1.2", {"--swell-up: 1.2", "onboard", "off"});
  expect_wrong_use(kAdvisor + " --hull x --swell-up tasaki", {"--swell-up: tasaki", "onboard", "off"});
  expect_wrong_use(responses + sea + " --mu-deg 90 --hours 0", {"--hours: 0", "0.01 ... 100000"});
  expect_wrong_use(responses + sea + " --mu-deg 90 --point 30,0", {"--point: 30,0", "x,y,z"});
  expect_wrong_use(responses + sea + " --mu-deg 90 --point 30,0,nan", {"--point: 30,0,nan", "x,y,z"});
  expect_wrong_use(responses + sea + " --mu-deg 90 --point 30,0,1,2", {"--point: 30,0,1,2", "x,y,z"});
  expect_wrong_use(responses + sea + " --mu-deg 90 --level rol=0.1", {"--level: rol=0.1", "roll, pitch"});
  expect_wrong_use(responses + sea + " --mu-deg 90 --level roll", {"--level: roll", "above 0 rad"});
  expect_wrong_use(responses + sea + " --mu-deg 90 --level roll=-0.1", {"--level: roll=-0.1", "above 0 rad"});
  expect_wrong_use(motions + " --mu-deg 90 --omega 0", {"--omega: 0"});
  expect_wrong_use(motions + " --mu-deg 0:359:0.05 --omega 0.1:20:0.005", {"at most 1000000"});
  expect_wrong_use(kHull + " hydrostatics " + kS175 + " --kg-m 1e308", {"--kg-m: 1e+308", "200"});
  expect_wrong_use(kHull + " grid " + kS175 + " --spectrum jonswap --hs-m 3 --t1-s 9 --dir-from-deg 725",
                   {"--dir-from-deg: 725"});
  expect_wrong_use(kHull + " grid " + kS175 + " --sea x --at yesterday --repeat 0", {"--repeat"});
  for (const std::string& option :
       {std::string("--cycle-s"), std::string("--own-ship-stale-after-s"), std::string("--sea-stale-after-s"),
        std::string("--loading-stale-after-s")}) {
    for (const char* value : {"nan", "inf", "0", "-1", "1e300"}) {
      expect_wrong_use(kAdvisor + " --hull none.toml " + option + " " + value, {option + ": "});
      expect_wrong_use(kSim + " replay none.log --hull none.toml " + option + " " + value, {option + ": "});
    }
  }
  expect_wrong_use(kAdvisor + " --hull x --source-id 99999", {"--source-id"});
  expect_wrong_use(kAdvisor + " --hull x --clock sundial", {"--clock"});
  expect_wrong_use(kSim + " replay x --hull x --speed nan", {"--speed: nan"});
  expect_wrong_use(kSim + " replay x --hull x --speed 0", {"--speed: 0"});
  expect_wrong_use(kSim + " story x --every-h 1e-12", {"--every-h: 1e-12"});
  expect_wrong_use(kSim + " log --sea x --voyage x --out x --own-ship-period-s nan",
                   {"--own-ship-period-s: nan"});
}

TEST_F(Programs, SimulationsThatCannotBeAreRefusedInOneLine) {
  const std::string ship = kSim + " simulate " + kS175;
  const std::string sea = " --spectrum bretschneider --hs-m 3 --t1-s 9";
  const std::string course = " --speed-kn 10 --mu-deg 90";
  const std::string run = " --hours 1 --seed 1";
  expect_bad(kSim + " simulate none.toml" + sea + course + run, {"none.toml: no such file"});
  expect_bad(ship + " --sea none.sea --speed-kn 10 --heading-deg 0" + run, {"none.sea: no such file"});
  expect_bad(ship + sea + course + run + " --log none/x.log", {"none/x.log: cannot be written"});
  expect_bad(ship + " --spectrum bretschneider --hs-m 3 --t1-s 1" + course + run, {"--t1-s", "rad/s"});
  expect_wrong_use(ship + sea + course + " --seed 1 --hours 0", {"--hours: 0", "0.02 ... 100000"});
  expect_wrong_use(ship + sea + course + " --seed 1 --hours -5", {"--hours: -5", "0.02 ... 100000"});
  expect_wrong_use(ship + sea + course + " --seed 1 --hours 1e7", {"--hours: ", "0.02 ... 100000"});
  expect_wrong_use(ship + sea + course + " --hours 1 --seed -1", {"--seed: -1", "0 or more"});
  expect_wrong_use(ship + sea + course + " --hours 1 --seed one", {"--seed: one", "0 or more"});
  expect_wrong_use(ship + sea + " --mu-deg 90 --speed-kn 99" + run, {"--speed-kn: 99", "0 ... 60"});
  expect_wrong_use(ship + sea + " --speed-kn 10" + run, {"--mu-deg or --heading-deg"});
  expect_wrong_use(ship + course + run, {"--spectrum"});
  expect_wrong_use(ship + sea + course + run + " --roll-damping-quadratic 1", {"--roll-damping-linear"});
}

TEST_F(Programs, DirectionsUpTo360AreTakenAndEchoedAsGiven) {
  const Outcome outcome =
      run(kHull + " motions " + kS175 + " --speed-kn 10 --mu-deg 360,-359.5,270 --omega 0.5");
  EXPECT_EQ(outcome.exit_code, 0) << outcome.err;
  for (const char* start : {"\n10,360,0.5,", "\n10,-359.5,0.5,", "\n10,270,0.5,"}) {
    EXPECT_NE(outcome.out.find(start), std::string::npos) << start;
  }
}

// Contract §2: a file that passes `quickstrip-hull check` is one that the advisor will load, and no other.
TEST_F(Programs, CheckAndAdvisorAgreeOnEveryFile) {
  const std::string good = source_text("sim/hulls/s175.hull.toml");
  const std::string kg = "kg_m = 9.55";
  const std::string aft = "draught_aft_m = 9.5\ndraught_fwd_m = 9.5";
  const std::vector<std::array<std::string, 2>> edits = {
      {kg, kg},
      {kg, "kg_m = 12.0"},
      {kg, "kg_m = 10.5439"},
      {kg, "kg_m = 0.001"},
      {kg, kg + "\ngm_m = 0.001"},
      {kg, kg + "\ngm_m = 50"},
      {kg, kg + "\nmeasured_roll_period_s = 80"},
      {"free_surface_correction_m = 0.0", "free_surface_correction_m = 2.0"},
      {aft, "draught_aft_m = 0.3\ndraught_fwd_m = 0.3"},
      {aft, "draught_aft_m = 10.9\ndraught_fwd_m = 2.2"},
      {aft, "draught_aft_m = 2.2\ndraught_fwd_m = 10.9"},
      {aft, "draught_aft_m = 10.999\ndraught_fwd_m = 10.999"},
      {"ratio = 0.05", "ratio = 0.0"},
      {"breadth_m = 25.4", "breadth_m = 17.0"},
      {"breadth_m = 25.4", "breadth_m = 30.0"},
      {"lpp_m = 175.0", "lpp_m = 220.0"},
      {"x_m = 4.375", "x_m = 0.001"},
      {"to = 24.0, step = 1.0", "to = 60.0, step = 2.5"},
      {"to = 24.0, step = 1.0", "to = 0.0, step = 1.0"},
      {"[[0.0, 9.02], [0.43", "[[0.0, 9.02], [0.43"},
  };
  int num_passed = 0;
  for (const auto& [from, to] : edits) {
    const std::string text =
        from == to || good.find(from) == std::string::npos ? good : edited(good, from, to);
    const std::string path = folder_.file("ship.toml", text);
    const auto files = std::make_unique<ShipFiles>();
    const auto session = std::make_unique<Session>();
    const bool is_loaded = read_ship_files(path, "", *files).ok() &&
                           session->configure(files->hull, files->criteria, SessionOptions{}).ok();
    const Outcome check = run(kHull + " check ship.toml");
    EXPECT_EQ(check.exit_code, is_loaded ? 0 : 1) << to << "\n" << check.err;
    if (!is_loaded) {
      EXPECT_EQ(check.err.find('\n'), check.err.size() - 1) << check.err;
    }
    num_passed += is_loaded ? 1 : 0;
  }
  EXPECT_GT(num_passed, 5);
  EXPECT_LT(num_passed, static_cast<int>(edits.size()));
}

TEST_F(Programs, TransformsThatCannotBeExitOneAndLeaveNothingBehind) {
  const std::string bad = folder_.file("bad.toml", "schema = 1\n");
  const std::string good = folder_.file("s175.toml", source_text("sim/hulls/s175.hull.toml"));
  const std::string transform = kHull + " transform s175.toml --out ";
  expect_bad(kHull + " transform none.toml --out o.toml", {"none.toml: no such file"});
  expect_bad(kHull + " transform bad.toml --out o.toml", {"bad.toml: name: missing"});
  expect_bad(transform + "none/o.toml", {"none/o.toml: cannot be written"});
  expect_bad(transform + ".", {".: a folder"});
  expect_bad(transform + "o.toml --change-cb 0.2", {"--change-cb = 0.2", "0.117 is possible"});
  expect_bad(transform + "o.toml --shift-lcb-lpp -0.08", {"--shift-lcb-lpp = -0.08", "is possible"});
  expect_bad(transform + "o.toml --shift-lcb-m 9 --change-cb 0.1",
             {"--shift-lcb-m = 9", "together are possible"});
  expect_bad(transform + "o.toml --scale 3", {"--scale = 3", "525 m", "2.857 is possible"});
  expect_bad(transform + "o.toml --scale 0.005", {"--scale = 0.005", "is possible"});
  expect_bad(transform + "o.toml --name \"a name of more than thirty-one bytes\"",
             {"--name: 36 bytes", "31"});
  expect_bad(transform + "./s175.toml --scale 2", {"./s175.toml", "itself"});
  EXPECT_EQ(text_of("s175.toml"), source_text("sim/hulls/s175.hull.toml"));
  expect_bad(kHull + " parametric tanker --out none/o.toml", {"none/o.toml: cannot be written"});
  expect_wrong_use(kHull + " parametric submarine --out o.toml", {"submarine", "trawler"});
  expect_wrong_use(transform + "o.toml --scale 0", {"--scale: 0"});
  expect_wrong_use(transform + "o.toml --change-cb nan", {"--change-cb: nan"});
  expect_wrong_use(transform + "o.toml --shift-lcb-m 1 --shift-lcb-lpp 0.01", {"excludes"});
  expect_wrong_use(kHull + " transform s175.toml", {"--out"});
}

TEST_F(Programs, ComparisonsWithoutAMeaningAreRefused) {
  const std::string ikeda = folder_.file("ikeda.toml", source_text("sim/hulls/s175.hull.toml"));
  const std::string figures =
      folder_.file("tank.csv", "hull,fn,quantity,abscissa,measured\nV,0.3,heave,1.25,0.7\n");
  const std::string sea = " --spectrum bretschneider --hs-m 3 --t1-s 9 --speed-kn 10";
  expect_bad(kHull + " frequencies ikeda.toml --mu-deg 90" + sea, {"ikeda.toml", "--roll-damping-ratio"});
  expect_wrong_use(kHull + " frequencies " + kS175 + " --mu-deg 92" + sea, {"--mu-deg: 92", "multiple of 5"});
  expect_wrong_use(kHull + " frequencies " + kS175 + " --mu-deg 90 --spreading-deg 20" + sea,
                   {"--spreading-deg", "long-crested"});
  const std::string tank = kHull + " tank ikeda.toml --with ";
  expect_bad(tank + "none.csv", {"none.csv: cannot be read"});
  expect_bad(tank + "tank.csv", {"tank.csv: hull = ikeda", "--model takes one of V"});
  expect_bad(tank + "ikeda.toml", {"ikeda.toml: line", "fn, quantity, abscissa, measured"});
  static_cast<void>(folder_.file("no_speed.csv", "hull,quantity,abscissa,measured\nV,heave,1.25,0.7\n"));
  expect_bad(tank + "no_speed.csv --model V", {"no_speed.csv: line 1", "fn, quantity, abscissa, measured"});
  static_cast<void>(folder_.file("yaw.csv", "fn,quantity,abscissa,measured\n0.3,yaw,1.25,0.7\n"));
  expect_bad(tank + "yaw.csv", {"yaw.csv: line 2: quantity = yaw", "heave, pitch, pitch_slope"});
  static_cast<void>(folder_.file("fast.csv", "fn,quantity,abscissa,measured\n3,heave,1.25,0.7\n"));
  expect_bad(tank + "fast.csv", {"fast.csv: line 2: fn = 3"});
  static_cast<void>(folder_.file("empty.csv", "fn,quantity,abscissa,measured\n"));
  expect_bad(tank + "empty.csv", {"empty.csv: holds no figure"});
  expect_wrong_use(tank + "tank.csv --format pdf", {"--format"});
  static_cast<void>(folder_.file("box.csv", "y_m,z_m\n0,-1\n1,-1\n1,0\n"));
  static_cast<void>(folder_.file("line.csv", "y_m,z_m\n0,-1\n1,0\n"));
  static_cast<void>(folder_.file("bulb.csv", "y_m,z_m\n0,-2\n1,-1.5\n0,-1\n"));
  static_cast<void>(folder_.file("loads.csv", "section,quantity,abscissa,measured\nbox,f3,0.5,0.6\n"));
  expect_bad(kHull + " section none.csv --with loads.csv", {"none.csv: cannot be read"});
  expect_bad(kHull + " section line.csv --with loads.csv", {"line.csv: ", "point"});
  expect_bad(kHull + " section bulb.csv --with loads.csv", {"bulb.csv: ends under water"});
  expect_bad(kHull + " section box.csv --with loads.csv --model hull", {"section = hull", "one of box"});
  expect_bad(kHull + " section box.csv --with box.csv", {"box.csv: line 1", "quantity, abscissa, measured"});
  expect_wrong_use(kHull + " section box.csv --with loads.csv --sections ursell", {"--sections"});
}

TEST_F(Programs, ATransformedShipIsOneThatCheckPasses) {
  for (const std::string& options :
       {std::string(), std::string(" --change-cb -0.04 --shift-lcb-lpp 0.015 --scale 0.5"),
        std::string(" --change-cb 0.04 --shift-lcb-lpp -0.015 --scale 1.5")}) {
    const Outcome made = run(kHull + " transform " + kS175 + " --out new.hull.toml" + options);
    EXPECT_EQ(made.exit_code, 0) << made.err;
    EXPECT_EQ(made.out.rfind("quantity,before,after\nlpp_m,175,", 0), 0U) << made.out;
    const Outcome checked = run(kHull + " check new.hull.toml");
    EXPECT_EQ(checked.exit_code, 0) << checked.err;
    EXPECT_NE(checked.out.find("S-175 container ship (changed)"), std::string::npos);
    EXPECT_EQ(checked.out.find("warning"), std::string::npos) << checked.out;
  }
  // Nothing changed: the same hydrostatics, to the digits that are printed.
  run(kHull + " transform " + kS175 + " --out new.hull.toml");
  EXPECT_EQ(run(kHull + " hydrostatics new.hull.toml").out, run(kHull + " hydrostatics " + kS175).out);
}

}  // namespace
}  // namespace quickstrip::test
