// SPDX-License-Identifier: Apache-2.0
// One thread serves all sockets and never waits. Other threads handle messages: messages of one page in their order,
// messages of several pages in parallel, so that reading a large document does not block other pages. Meanwhile further
// messages arrive and stop readings that they make useless. A request of a page is read only after its Host, its token
// and, for sockets, its Origin have been checked.
#include "server.h"

#include <algorithm>
#include <array>
#include <chrono>
#include <csignal>
#include <cstdlib>
#include <deque>
#include <filesystem>
#include <list>
#include <memory>
#include <set>
#include <string_view>
#include <thread>
#include <utility>

#include <boost/asio/io_context.hpp>
#include <boost/asio/ip/tcp.hpp>
#include <boost/asio/post.hpp>
#include <boost/asio/signal_set.hpp>
#include <boost/asio/steady_timer.hpp>
#include <boost/asio/strand.hpp>
#include <boost/asio/thread_pool.hpp>
#include <boost/beast/core.hpp>
#include <boost/beast/http.hpp>
#include <boost/beast/websocket.hpp>
#include <fcntl.h>
#include <fmt/format.h>

#include "addresses.h"
#include "meristem/base/diagnostic.h"
#include "meristem/document/json.h"
#include "meristem/document/parameter_tables.h"
#include "page_files.h"
#include "studio_session.h"

namespace meristem::studio {

namespace {

namespace asio = boost::asio;
namespace beast = boost::beast;
namespace http = beast::http;
namespace websocket = beast::websocket;
using tcp = asio::ip::tcp;
using Socket = websocket::stream<beast::tcp_stream>;
using HttpRequest = http::request<http::empty_body>;

constexpr std::uint16_t kPortsTried = 8;
constexpr std::uint32_t kMaxHeadBytes = 16'384;  // size of a request's head
// Any user of this machine can connect. Connections without the secret get few places and little time, so that they
// cannot keep a page out.
constexpr std::size_t kMaxUnauthenticated = 32;
constexpr std::chrono::seconds kUnauthenticatedPatience{5};  // for the complete head of the first request
constexpr std::size_t kMaxAuthenticated = 64;                // HTTP connections; browsers keep some of them open
constexpr std::chrono::seconds kHttpPatience{30};            // for one request or answer of an authenticated connection
constexpr std::chrono::milliseconds kAcceptPause{100};       // after the system has refused a connection
constexpr std::chrono::milliseconds kFarewell{200};          // for closing sockets
constexpr std::chrono::milliseconds kMaxEnding{800};         // from a signal until the program certainly ends
constexpr std::size_t kMaxWaiting = 64;                      // messages of a page that wait to be handled
constexpr std::size_t kMaxQueuedBytes = 512'000'000;         // for a page that does not read
constexpr std::uint64_t kMaxBeyond = 1'000'000;
constexpr std::size_t kMaxQueuedMessages = 64;  // with more messages, progress is not reported

class SocketConnection;
class HttpConnection;

/// Data that all connections share.
struct Serving {
  Host& host;
  std::string token;
  std::uint16_t port = 0;
  std::string tables{};
  std::set<SocketConnection*> sockets{};  // open sockets, and sockets that are being opened
  // HTTP connections, sorted by the time of their last request, oldest first.
  std::list<HttpConnection*> unauthenticated{};
  std::list<HttpConnection*> authenticated{};
  asio::thread_pool sessions{static_cast<std::size_t>(host.limits.connections) + 1};  // threads that handle messages
  asio::io_context io{1};  // last member, because its work uses the others
};

bool is_progress(std::string_view message) { return message.substr(0, 17) == R"({"is": "working",)"; }

/// A page's socket. Its session runs only on its strand of the message threads.
class SocketConnection : public std::enable_shared_from_this<SocketConnection> {
 public:
  SocketConnection(Serving& serving, beast::tcp_stream stream)
      : serving_(serving), socket_(std::move(stream)), strand_(serving.sessions.get_executor()) {
    serving_.sockets.insert(this);
  }
  SocketConnection(const SocketConnection&) = delete;
  SocketConnection& operator=(const SocketConnection&) = delete;

  void accept(const HttpRequest& request) {
    beast::get_lowest_layer(socket_).expires_never();
    socket_.set_option(websocket::stream_base::timeout::suggested(beast::role_type::server));
    // The limit is a little higher, so that the session can report which limit a message has exceeded. Larger messages
    // close the socket.
    socket_.read_message_max(serving_.host.limits.message_bytes + kMaxBeyond);
    socket_.auto_fragment(false);
    socket_.async_accept(request, [self = shared_from_this()](beast::error_code error) {
      if (error) return self->end();
      self->is_open_ = true;
      self->begin();
    });
  }

  void enqueue(bool is_text, std::string message) {
    if (!is_open_) return;
    if (is_text && queue_.size() >= kMaxQueuedMessages && is_progress(message)) return;
    queued_bytes_ += message.size();
    queue_.emplace_back(is_text, std::move(message));
    if (queued_bytes_ > kMaxQueuedBytes) return close(websocket::close_code::policy_error, "the page does not read");
    if (queue_.size() == 1) write();
  }

  void close(websocket::close_code code, const char* reason) {
    if (!std::exchange(is_open_, false)) return;
    socket_.async_close({code, reason}, [self = shared_from_this()](beast::error_code) {});
    end_session();
  }

  /// Stops the session's reading. Waiting messages are not handled any more.
  void stop_reading() { readings_->close(); }
  /// Destroys the session. Called after the message threads have ended.
  void drop_session() { session_ = nullptr; }

 private:
  void begin();

  void read() {
    socket_.async_read(buffer_, [self = shared_from_this()](beast::error_code error, std::size_t) {
      self->is_reading_ = false;
      if (error) return self->end();
      auto message = std::make_shared<std::string>(beast::buffers_to_string(self->buffer_.data()));
      self->buffer_.consume(self->buffer_.size());
      self->buffer_.shrink_to_fit();
      // Binary messages are invalid. The session refuses them like any text that is not JSON.
      const bool is_text = self->socket_.got_text();
      self->readings_->arrive(is_text ? std::string_view(*message) : std::string_view());
      ++self->waiting_;
      self->waiting_bytes_ += message->size();
      const auto handle = [message, is_text](SocketConnection& here) {
        if (here.session_ == nullptr || here.readings_->is_closed()) return;
        here.session_->receive(is_text ? std::string_view(*message) : std::string_view());
      };
      self->do_with_session(handle, [bytes = message->size()](SocketConnection& here) {
        --here.waiting_;
        here.waiting_bytes_ -= bytes;
      });
      self->read_on();
    });
  }

  /// Reads the next message, unless too many messages wait.
  void read_on() {
    const bool is_full = waiting_ >= kMaxWaiting || waiting_bytes_ > serving_.host.limits.message_bytes;
    if (!is_open_ || is_reading_ || is_full) return;
    is_reading_ = true;
    read();
  }

  void write() {
    socket_.text(queue_.front().first);
    socket_.async_write(asio::buffer(queue_.front().second),
                        [self = shared_from_this()](beast::error_code error, std::size_t) {
                          if (error) return self->end();
                          self->queued_bytes_ -= self->queue_.front().second.size();
                          self->queue_.pop_front();
                          if (self->is_open_ && !self->queue_.empty()) self->write();
                        });
  }

  void end() {
    is_open_ = false;
    end_session();
  }

  void end_session() {
    serving_.sockets.erase(this);
    stop_reading();
    do_with_session([](SocketConnection& here) { here.session_ = nullptr; }, [](SocketConnection&) {});
  }

  /// Calls `act` on a message thread, after all earlier calls, and then `then` on this thread, which continues to read.
  /// The connection is destroyed on this thread only.
  template <class Act, class Then>
  void do_with_session(Act act, Then then) {
    asio::post(strand_, [self = shared_from_this(), act = std::move(act), then = std::move(then)]() mutable {
      act(*self);
      asio::io_context& io = self->serving_.io;
      asio::post(io, [self = std::move(self), then = std::move(then)] {
        then(*self);
        self->read_on();
      });
    });
  }

  Serving& serving_;
  Socket socket_;
  beast::flat_buffer buffer_;
  std::deque<std::pair<bool, std::string>> queue_;  // whether it is text, and content; the first one is being sent
  std::size_t queued_bytes_ = 0;
  bool is_open_ = false;
  bool is_reading_ = false;
  std::size_t waiting_ = 0;  // number and bytes of waiting messages
  std::size_t waiting_bytes_ = 0;
  const std::shared_ptr<Readings> readings_ = std::make_shared<Readings>();
  asio::strand<asio::thread_pool::executor_type> strand_;
  std::unique_ptr<StudioSession> session_;  // used only on the strand
};

/// Passes messages from any thread to a socket that may have closed.
class SocketOutbox : public Outbox {
 public:
  SocketOutbox(asio::io_context& io, std::weak_ptr<SocketConnection> connection)
      : io_(io), connection_(std::move(connection)) {}

 private:
  void deliver_text(std::string message) override { send(true, std::move(message)); }
  void deliver_packet(std::string packet) override { send(false, std::move(packet)); }
  void send(bool is_text, std::string message) {
    asio::post(io_, [connection = connection_, is_text, message = std::move(message)]() mutable {
      if (const auto still = connection.lock()) still->enqueue(is_text, std::move(message));
    });
  }

  asio::io_context& io_;
  std::weak_ptr<SocketConnection> connection_;
};

void SocketConnection::begin() {
  do_with_session(
      [](SocketConnection& here) {
        auto outbox = std::make_shared<SocketOutbox>(here.serving_.io, here.weak_from_this());
        here.session_ = std::make_unique<StudioSession>(here.serving_.host, std::move(outbox), here.readings_);
      },
      [](SocketConnection&) {});
}

/// A connection that requests pages, until it becomes a socket.
class HttpConnection : public std::enable_shared_from_this<HttpConnection> {
 public:
  HttpConnection(Serving& serving, tcp::socket socket) : serving_(serving), stream_(std::move(socket)) {
    serving_.unauthenticated.push_back(this);
  }
  ~HttpConnection() { leave(); }
  HttpConnection(const HttpConnection&) = delete;
  HttpConnection& operator=(const HttpConnection&) = delete;

  /// Returns true while a request is answered.
  bool is_answering() const { return is_answering_; }

  /// Closes the connection.
  void drop() {
    leave();
    stream_.close();
  }

  void read() {
    is_answering_ = false;
    parser_.emplace();
    parser_->header_limit(kMaxHeadBytes);
    parser_->body_limit(0);
    // The end is fixed, so that a slow trickle of bytes does not extend it.
    stream_.expires_after(patience());
    http::async_read(stream_, buffer_, *parser_, [self = shared_from_this()](beast::error_code error, std::size_t) {
      self->is_answering_ = true;
      if (error == http::error::header_limit)
        return self->refuse(http::status::request_header_fields_too_large,
                            "the request's head is too long (16384 bytes)");
      if (error == http::error::body_limit)
        return self->refuse(http::status::payload_too_large, "requests have no body here (0 bytes)");
      if (error) return;
      self->answer();
    });
  }

 private:
  std::string_view header(http::field field) const {
    const auto text = parser_->get()[field];
    return {text.data(), text.size()};
  }

  std::chrono::seconds patience() const { return is_authenticated_ ? kHttpPatience : kUnauthenticatedPatience; }

  void leave() { (is_authenticated_ ? serving_.authenticated : serving_.unauthenticated).remove(this); }

  /// Moves the connection to the list of authenticated ones. Returns false if the list is full.
  bool authenticate();

  void answer() {
    const HttpRequest& request = parser_->get();
    const auto hosts = request.equal_range(http::field::host);
    const std::string_view host = header(http::field::host);
    if (std::distance(hosts.first, hosts.second) != 1 || !is_own_host(host, serving_.port))
      return refuse(http::status::forbidden, "the studio does not serve this host");
    const auto name = name_below_token({request.target().data(), request.target().size()}, serving_.token);
    if (!name) return refuse(http::status::not_found, "there is nothing here");
    if (!authenticate()) {
      return refuse(http::status::service_unavailable,
                    fmt::format("{} answers are on their way already", kMaxAuthenticated));
    }
    if (*name == "socket") return upgrade();
    if (request.method() != http::verb::get && request.method() != http::verb::head)
      return refuse(http::status::method_not_allowed, "only GET and HEAD are served");
    send_file(*name);
  }

  void upgrade() {
    const HttpRequest& request = parser_->get();
    if (!websocket::is_upgrade(request)) return refuse(http::status::upgrade_required, "this is a WebSocket");
    if (!is_own_origin(header(http::field::origin), serving_.port))
      return refuse(http::status::forbidden, "this is not the page that is served");
    if (serving_.sockets.size() >= static_cast<std::size_t>(serving_.host.limits.connections)) {
      return refuse(http::status::service_unavailable,
                    fmt::format("there are {} pages already (connections)", serving_.host.limits.connections));
    }
    auto socket = std::make_shared<SocketConnection>(serving_, std::move(stream_));
    socket->accept(request);
  }

  void send_file(const std::string& name) {
    constexpr std::string_view kDownloads = "downloads/";
    if (name.starts_with(kDownloads)) return send_download(std::string_view(name).substr(kDownloads.size()));
    if (name == "tables.json") return send_text(http::status::ok, "application/json", serving_.tables);
    const std::string file = name.empty() ? "index.html" : name;
    if (const std::optional<PageFile> page = page_file(file)) {
      auto response = begin_response<http::string_body>(http::status::ok, media_type(file));
      if (page->is_compressed) response.set(http::field::content_encoding, "gzip");
      response.body() = std::string(page->bytes);
      return send(std::move(response));
    }
    if (name.empty() && !has_page()) {
      return send_text(http::status::ok, "text/plain; charset=utf-8",
                       "This program was built without the studio's page: it needs node where it is built.\n");
    }
    refuse(http::status::not_found, "there is nothing here");
  }

  void send_download(std::string_view name) {
    const std::size_t slash = name.find('/');
    std::uint64_t number = 0;
    const std::string_view digits = name.substr(0, slash);
    const bool is_number = !digits.empty() && digits.size() < 18 &&
                           std::all_of(digits.begin(), digits.end(), [](char c) { return c >= '0' && c <= '9'; });
    if (slash == std::string_view::npos || !is_number) return refuse(http::status::not_found, "there is nothing here");
    for (const char digit : digits) number = 10 * number + static_cast<std::uint64_t>(digit - '0');
    const std::string file(name.substr(slash + 1));
    const std::optional<std::string> path = serving_.host.downloads.find(number, file);
    beast::error_code error;
    http::file_body::value_type body;
    if (path) body.open(path->c_str(), beast::file_mode::scan, error);
    if (!path || error) return refuse(http::status::not_found, "this no longer exists");
    auto response = begin_response<http::file_body>(http::status::ok, media_type(file));
    response.set(http::field::content_disposition, "attachment; filename=\"" + file + "\"");
    response.body() = std::move(body);
    send(std::move(response));
  }

  template <class Body>
  http::response<Body> begin_response(http::status status, std::string_view type) {
    http::response<Body> response(status, 11);
    response.set(http::field::content_type, beast::string_view(type.data(), type.size()));
    response.set(http::field::cache_control, "no-store");
    response.set("X-Content-Type-Options", "nosniff");
    response.set("Referrer-Policy", "no-referrer");
    response.set("Cross-Origin-Resource-Policy", "same-origin");
    response.set("Cross-Origin-Opener-Policy", "same-origin");
    response.set("X-Frame-Options", "DENY");
    response.set("Content-Security-Policy",
                 security_policy(fmt::format("127.0.0.1:{0} ws://localhost:{0}", serving_.port)));
    return response;
  }

  void send_text(http::status status, std::string_view type, std::string text) {
    auto response = begin_response<http::string_body>(status, type);
    response.body() = std::move(text);
    send(std::move(response));
  }

  void refuse(http::status status, std::string text) {
    is_last_ = true;
    send_text(status, "text/plain; charset=utf-8", text + "\n");
  }

  template <class Body>
  void send(http::response<Body> response) {
    const bool wants_head = parser_->get().method() == http::verb::head;
    response.keep_alive(!is_last_ && parser_->get().keep_alive());
    response.prepare_payload();
    auto kept = std::make_shared<http::response<Body>>(std::move(response));
    const auto then = [self = shared_from_this(), kept](beast::error_code error, std::size_t) {
      if (error || !kept->keep_alive()) {
        beast::error_code ignored;
        self->stream_.socket().shutdown(tcp::socket::shutdown_send, ignored);
        return;
      }
      self->read();
    };
    stream_.expires_after(patience());
    if (wants_head) {
      auto serializer = std::make_shared<http::response_serializer<Body>>(*kept);
      http::async_write_header(stream_, *serializer,
                               [then, serializer](beast::error_code error, std::size_t bytes) { then(error, bytes); });
    } else {
      http::async_write(stream_, *kept, then);
    }
  }

  Serving& serving_;
  beast::tcp_stream stream_;
  beast::flat_buffer buffer_;
  std::optional<http::request_parser<http::empty_body>> parser_;
  bool is_last_ = false;
  bool is_authenticated_ = false;
  bool is_answering_ = false;
};

/// Drops the connection that has waited longest for a request if the list is full. Returns false if the list stays full
/// because all connections are being answered.
bool make_room(std::list<HttpConnection*>& connections, std::size_t maximum) {
  if (connections.size() < maximum) return true;
  const auto idle = std::find_if(connections.begin(), connections.end(),
                                 [](const HttpConnection* connection) { return !connection->is_answering(); });
  if (idle == connections.end()) return false;
  (*idle)->drop();
  return true;
}

bool HttpConnection::authenticate() {
  leave();
  const bool has_room = is_authenticated_ || make_room(serving_.authenticated, kMaxAuthenticated);
  is_authenticated_ = is_authenticated_ || has_room;
  (is_authenticated_ ? serving_.authenticated : serving_.unauthenticated).push_back(this);
  return has_room;
}

/// Closes a socket in programs that this one starts. Otherwise a browser that outlives the studio would keep its port.
void close_on_exec(int descriptor) { ::fcntl(descriptor, F_SETFD, FD_CLOEXEC); }

void admit(Serving& serving, tcp::socket socket) {
  close_on_exec(socket.native_handle());
  // All connections in the list are being refused, so the oldest one is closed early.
  if (!make_room(serving.unauthenticated, kMaxUnauthenticated)) serving.unauthenticated.front()->drop();
  std::make_shared<HttpConnection>(serving, std::move(socket))->read();
}

void accept_next(Serving& serving, tcp::acceptor& acceptor) {
  acceptor.async_accept([&serving, &acceptor](beast::error_code error, tcp::socket socket) {
    if (!acceptor.is_open()) return;
    if (!error) {
      admit(serving, std::move(socket));
      return accept_next(serving, acceptor);
    }
    // The system may have no descriptors left. A retry without a pause would keep a processor busy.
    auto pause = std::make_shared<asio::steady_timer>(serving.io, kAcceptPause);
    pause->async_wait([&serving, &acceptor, pause](beast::error_code) {
      if (acceptor.is_open()) accept_next(serving, acceptor);
    });
  });
}

/// Starts to listen at the port on this machine's loopback address. Returns true on success.
bool listen(tcp::acceptor& acceptor, std::uint16_t port) {
  const tcp::endpoint here(asio::ip::address_v4::loopback(), port);
  beast::error_code error;
  acceptor.open(here.protocol(), error);
  if (!error) close_on_exec(acceptor.native_handle());
  if (!error) acceptor.set_option(asio::socket_base::reuse_address(true), error);
  if (!error) acceptor.bind(here, error);
  if (!error) acceptor.listen(asio::socket_base::max_listen_connections, error);
  if (!error) return true;
  beast::error_code ignored;
  acceptor.close(ignored);
  return false;
}

void listen(tcp::acceptor& acceptor, const ServeOptions& options) {
  if (options.port) {
    if (listen(acceptor, *options.port)) return;
    throw MachineError(
        fmt::format("cannot listen on port {} of 127.0.0.1: another program may have it", *options.port));
  }
  for (std::uint16_t k = 0; k < kPortsTried; ++k) {
    if (listen(acceptor, static_cast<std::uint16_t>(kUsualPort + k))) return;
  }
  throw MachineError(fmt::format("cannot listen on 127.0.0.1: the ports {} to {} are taken; --port N names another",
                                 kUsualPort, kUsualPort + kPortsTried - 1));
}

/// Ends the program after kMaxEnding, even if running work does not stop or large memory is still being freed. Files
/// are written whole or not at all, so no incomplete file remains. `folder` has the files of exports, or is empty.
void end_in_time(const std::string& folder) {
  std::thread([folder] {
    std::this_thread::sleep_for(kMaxEnding);
    std::error_code ignored;
    if (!folder.empty()) std::filesystem::remove_all(folder, ignored);
    std::_Exit(EXIT_SUCCESS);
  }).detach();
}

}  // namespace

void serve(Host& host, const ServeOptions& options, const std::function<void(const std::string& address)>& ready) {
  Serving serving{.host = host, .token = options.token.empty() ? secret_token() : options.token};
  serving.tables = write_json_line(parameter_tables(host.registry));
  tcp::acceptor acceptor(serving.io);
  listen(acceptor, options);
  serving.port = acceptor.local_endpoint().port();

  asio::signal_set signals(serving.io, SIGINT, SIGTERM);
  asio::steady_timer farewell(serving.io);
  signals.async_wait([&](beast::error_code error, int) {
    if (error) return;
    end_in_time(host.downloads.made_folder());
    if (options.on_end) options.on_end();
    beast::error_code ignored;
    acceptor.close(ignored);
    const std::set<SocketConnection*> open = serving.sockets;
    for (SocketConnection* socket : open) socket->close(websocket::close_code::going_away, "the studio ends");
    farewell.expires_after(kFarewell);
    farewell.async_wait([&serving](beast::error_code) { serving.io.stop(); });
  });
  accept_next(serving, acceptor);
  ready(fmt::format("http://127.0.0.1:{}/{}/", serving.port, serving.token));
  serving.io.run();
  // Message threads must end before the sockets that they use.
  for (SocketConnection* socket : serving.sockets) socket->stop_reading();
  serving.sessions.join();
  for (SocketConnection* socket : serving.sockets) socket->drop_session();
  host.growth.stop();
  host.exports.stop();
  host.films.stop();
  host.stills.stop();
}

}  // namespace meristem::studio
