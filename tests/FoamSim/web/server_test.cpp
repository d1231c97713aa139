// Who is answered by the server of a run, and what it gives.
#include "FoamSim/web/server/server.h"

#include <gtest/gtest.h>

#include <atomic>
#include <boost/asio/connect.hpp>
#include <boost/asio/ip/tcp.hpp>
#include <boost/asio/read.hpp>
#include <boost/asio/write.hpp>
#include <fstream>
#include <nlohmann/json.hpp>
#include <thread>

#include "Base/error.h"
#include "FoamSim/web/server/run_pages.h"
#include "small_run.h"
#include "tests/support/run_program.h"

namespace foamsim::web {
namespace {

namespace asio = boost::asio;
namespace fs = std::filesystem;
using asio::ip::tcp;

const std::string secret = "0123456789abcdef";

WebRequest good(const std::string& path = "") {
  return {"GET", "/" + secret + "/" + path, "127.0.0.1:8080", "", ""};
}

int verdict(const WebRequest& request) {
  return RequestCheck(8080, secret).judge(request).status;
}

TEST(RequestCheck, AnswersItsOwnPage) {
  EXPECT_EQ(verdict(good()), 200);
  EXPECT_EQ(verdict(good("run.json")), 200);
  WebRequest from_page = good();
  from_page.host = "localhost:8080";
  from_page.origin = "http://localhost:8080";
  from_page.fetch_site = "same-origin";
  EXPECT_EQ(verdict(from_page), 200);
  EXPECT_EQ(RequestCheck(8080, secret).path(good("frame/12?x=1")), "frame/12");
}

TEST(RequestCheck, WantsTheToken) {
  for (const std::string& target : {std::string("/"), std::string(""), "/" + secret, "/" + secret.substr(1) + "0/",
                                    std::string("/run.json"), "/x" + secret + "/", "/../" + secret + "/"}) {
    WebRequest request = good();
    request.target = target;
    EXPECT_EQ(verdict(request), 404) << target;
  }
}

TEST(RequestCheck, RefusesOtherHostsAndOrigins) {
  for (const char* host : {"", "example.org", "example.org:8080", "127.0.0.1", "127.0.0.1:80", "127.0.0.1:8080.org"}) {
    WebRequest request = good();
    request.host = host;
    EXPECT_EQ(verdict(request), 403) << host;
  }
  for (const char* origin : {"http://example.org", "null", "https://127.0.0.1:8080", "http://127.0.0.1:9"}) {
    WebRequest request = good();
    request.origin = origin;
    EXPECT_EQ(verdict(request), 403) << origin;
  }
  WebRequest request = good();
  request.fetch_site = "cross-site";
  EXPECT_EQ(verdict(request), 403);
}

TEST(RequestCheck, TakesGetAlone) {
  for (const char* method : {"POST", "PUT", "DELETE", "HEAD", "OPTIONS", "get"}) {
    WebRequest request = good();
    request.method = method;
    EXPECT_EQ(verdict(request), 405) << method;
  }
}

TEST(RunPages, GiveThePageTheRunAndItsFrames) {
  const test::SmallRun run;
  RunPages pages(run.path(), test::stub_page, {});
  EXPECT_NE(pages.answer("").body.find("foamsim-live"), std::string::npos);
  const nlohmann::json description = nlohmann::json::parse(pages.answer("run.json").body);
  EXPECT_EQ(description["frames"].size(), 4u);
  EXPECT_EQ(test::gunzip(pages.answer("frame/2").body).substr(0, 4), "FSF1");
}

TEST(RunPages, GiveNothingElse) {
  const test::SmallRun run;
  RunPages pages(run.path(), test::stub_page, {});
  for (const char* path : {"frame/3", "frame/", "frame/-2", "frame/2/../../run.json", "../run.json", "..%2frun.json",
                           "metrics.csv", "frames/frame_000002.ply", "/etc/passwd", "run.json/", "RUN.JSON"})
    EXPECT_EQ(pages.answer(path).status, 404) << path;
}

TEST(RunPages, SeeFramesThatTheRunAddsAndReplaces) {
  const test::SmallRun run;
  fs::rename(run.frame(6), run.path() / "later");
  RunPages pages(run.path(), test::stub_page, {});
  EXPECT_EQ(pages.answer("frame/6").status, 404);
  fs::rename(run.path() / "later", run.frame(6));
  pages.answer("run.json");
  EXPECT_EQ(pages.answer("frame/6").status, 200);
  const std::string before = pages.answer("frame/6").body;
  fs::copy_file(run.frame(0), run.frame(6), fs::copy_options::overwrite_existing);
  fs::last_write_time(run.frame(6), fs::file_time_type::clock::now() + std::chrono::seconds(5));
  EXPECT_NE(pages.answer("frame/6").body, before);
}

TEST(RunPages, SayWhatIsDamaged) {
  const test::SmallRun run;
  RunPages pages(run.path(), test::stub_page, {});
  run.write("frames/frame_000004.ply", "ply\nno\n");
  const WebAnswer answer = pages.answer("frame/4");
  EXPECT_EQ(answer.status, 500);
  EXPECT_NE(answer.body.find("frame_000004.ply"), std::string::npos) << answer.body;
  EXPECT_THROW(RunPages(run.path() / "frames", test::stub_page, {}), base::InputError);
  EXPECT_THROW(RunPages(run.path(), test::stub_page, {.fields = {"nothing"}}), base::InputError);
}

// A server in a thread of its own, and what raw requests get from it.
class RunningServer : public testing::Test {
 public:
  ~RunningServer() override {
    stop_ = true;
    thread_.join();
  }

 protected:
  std::string head(const std::string& line, const std::string& more = "") const {
    return line + " HTTP/1.1\r\nHost: 127.0.0.1:" + std::to_string(server_.port()) + "\r\n" + more +
           "Connection: close\r\n\r\n";
  }

  // All that comes until the connection is closed.
  std::string send(const std::string& bytes) const {
    asio::io_context context;
    tcp::socket socket(context);
    socket.connect({asio::ip::address_v4::loopback(), server_.port()});
    boost::system::error_code error;
    asio::write(socket, asio::buffer(bytes), error);
    std::string answer;
    asio::read(socket, asio::dynamic_buffer(answer), error);
    return answer;
  }

  std::string token_path() const { return server_.address().substr(server_.address().find('/', 7)); }

  Server server_{{}, [](const std::string& path) { return WebAnswer{200, "text/plain", "path=" + path}; }};

 private:
  std::atomic<bool> stop_ = false;
  std::thread thread_{[this] { server_.run([this] { return stop_.load(); }); }};
};

TEST_F(RunningServer, AnswersWithTheTokenOnly) {
  const std::string answer = send(head("GET " + token_path() + "frame/7"));
  EXPECT_TRUE(answer.starts_with("HTTP/1.1 200")) << answer;
  EXPECT_TRUE(answer.ends_with("path=frame/7")) << answer;
  EXPECT_NE(answer.find("nosniff"), std::string::npos);
  EXPECT_TRUE(send(head("GET /frame/7")).starts_with("HTTP/1.1 404"));
  EXPECT_TRUE(send(head("POST " + token_path())).starts_with("HTTP/1.1 405"));
  EXPECT_TRUE(send(head("GET " + token_path(), "Origin: http://example.org\r\n")).starts_with("HTTP/1.1 403"));
  EXPECT_TRUE(send(head("GET " + token_path(), "Host: example.org\r\n")).starts_with("HTTP/1.1 403"));
}

TEST_F(RunningServer, ClosesOnWhatIsNoRequestAndGoesOn) {
  EXPECT_EQ(send("\x16\x03\x01 nonsense\r\n\r\n"), "");
  EXPECT_EQ(send(head("GET /" + std::string(100000, 'a'))), "");
  EXPECT_EQ(send(head("GET " + token_path(), "Content-Length: 1000000\r\n")), "");
  EXPECT_TRUE(send(head("GET " + token_path())).starts_with("HTTP/1.1 200"));
}

TEST_F(RunningServer, RefusesAPortThatIsInUse) {
  try {
    const Server second({server_.port()}, [](const std::string&) { return WebAnswer{}; });
    FAIL();
  } catch (const base::InputError& error) {
    EXPECT_NE(std::string(error.what()).find("is in use"), std::string::npos) << error.what();
  }
}

}  // namespace
}  // namespace foamsim::web
