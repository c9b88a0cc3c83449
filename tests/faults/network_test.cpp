// The network lost and back: no advice is taken for new meanwhile, and all is as before afterwards.
#include <cstdlib>

#include "tests/faults/fault_test.hpp"

namespace quickstrip::faults {
namespace {

bool shell(const std::string& command) {
  return std::system((command + " >/dev/null 2>&1").c_str()) == 0;
}

class Network : public FaultTest {
 protected:
  void SetUp() override {
    if (std::getenv("QS_OWN_NETWORK") == nullptr) {
      GTEST_SKIP() << "not in a network of its own: it would be everybody's that is lost";
    }
    start();
    send_sea(kBadSea_m);
    ASSERT_TRUE(until_advice());
  }
  /// Two seconds without, then with.
  void lose_and_restore(const std::string& lose, const std::string& restore) {
    ASSERT_TRUE(shell(lose));
    listen(0.3);
    const int before = num_advices_;
    listen(2.0);
    EXPECT_EQ(num_advices_, before) << "the network is not lost";
    ASSERT_TRUE(shell(restore));
    if (!advisor_.is_running()) {  // the unit starts it again; what it had said then must be said
      EXPECT_NE(advisor_.journal().find("LCM has failed"), std::string::npos) << advisor_.journal();
      start();
    }
    send_sea(kBadSea_m);
    ASSERT_TRUE(until_advice()) << why_not();
    EXPECT_EQ(advice_.verdict, int{advice_t::VERDICT_EXCEEDED});
  }
};

TEST_F(Network, AnInterfaceThatGoesDownAndUpIsSurvivedAndCounted) {
  lose_and_restore("ip link set lo down", "ip link set lo up && ip route add 224.0.0.0/4 dev lo");
  ASSERT_TRUE(until([this] { return health_.publish_failures > 0; })) << "lost advice is not counted";
}

TEST_F(Network, ARouteThatIsLostAndFoundIsSurvivedAndCounted) {
  lose_and_restore("ip route del 224.0.0.0/4 dev lo", "ip route add 224.0.0.0/4 dev lo");
  ASSERT_TRUE(until([this] { return health_.publish_failures > 0; })) << "lost advice is not counted";
}

}  // namespace
}  // namespace quickstrip::faults
