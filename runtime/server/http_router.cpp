#include "server/http_router.h"

#include "server/allowed_host.h"
#include "server/api.h"
#include "server/client_message.h"
#include "server/messages.h"
#include "server/server_messages.h"

namespace mirada::server {
namespace {

constexpr std::uint64_t kMaxOtherBody = 256u << 10;
constexpr const char* kJson = "application/json";

HttpReply json_reply(std::string body) {
  return {200, kJson, std::move(body), {{"Cache-Control", "no-store"}}};
}

bool matches(std::string_view if_none_match, std::string_view etag) {
  return if_none_match == "*" || if_none_match.find(etag) != std::string_view::npos;
}

HttpReply file_reply(const HttpRequest& request, StaticFile file) {
  HttpReply reply{
      200, std::string(file.type), std::move(file.bytes), {{"ETag", file.etag}, {"Vary", "Accept-Encoding"}}};
  reply.headers.emplace_back("Cache-Control",
                             file.immutable ? "public, max-age=31536000, immutable" : "no-cache");
  if (file.gzip) reply.headers.emplace_back("Content-Encoding", "gzip");
  if (!request.if_none_match.empty() && matches(request.if_none_match, file.etag)) {
    reply.status = 304;
    reply.body.clear();
  }
  return reply;
}

HttpReply api_reply(const HttpRequest& request, const RouterData& data) {
  const std::string_view path = request.path();
  if (path == "/api/packs") return json_reply(data.packs_json);
  if (path == "/api/setup") return json_reply(setup_page_json(data.station, data.lang));
  if (path == "/api/examples") return json_reply(data.examples_json);
  const bool other_method = path == "/api/check" || path == "/api/scratch" || path == "/api/stop";
  return other_method ? refusal(405, messages::method_wrong, path)
                      : refusal(404, messages::page_missing, path);
}

HttpReply page_reply(const HttpRequest& request, const RouterData& data) {
  if (auto file = data.files.find(request.target, accepts_gzip(request.accept_encoding))) {
    return file_reply(request, std::move(*file));
  }
  if (request.path() == "/" && !data.files.built()) {
    return {200,
            "text/html; charset=utf-8",
            plain_page(messages::editor_missing, {}, &messages::robot_works),
            {{"Cache-Control", "no-store"}}};
  }
  return refusal(404, messages::page_missing, request.target);
}

}  // namespace

HttpReply refusal(unsigned status, const Message& message, std::string_view target, const MessageArgs& args) {
  HttpReply reply{status, kJson, "", {{"Cache-Control", "no-store"}}};
  if (target.starts_with("/api/")) {
    reply.body = check_json({make_fault("", message, args)});
  } else {
    reply.type = "text/html; charset=utf-8";
    reply.body = plain_page(message, args);
  }
  return reply;
}

bool is_stop(const HttpRequest& request) { return request.method == "POST" && request.path() == "/api/stop"; }
bool is_check(const HttpRequest& request) {
  return request.method == "POST" && request.path() == "/api/check";
}

bool is_scratch(const HttpRequest& request) {
  return request.method == "POST" && request.path() == "/api/scratch";
}

std::optional<HttpReply> refuse(const HttpRequest& request, std::string_view local_address,
                                std::string_view machine_name) {
  const std::string_view target = request.path();
  if (request.transfer_encoding || request.content_lengths.size() > 1) {
    return refusal(400, messages::request_chunked, target);
  }
  if (request.hosts.size() != 1) return refusal(400, messages::host_needed, target);
  const std::string_view host = request.hosts.front();
  if (!host_allowed(host, local_address, machine_name)) return refusal(421, messages::host_wrong, target);
  const bool harmless = (request.method == "GET" || request.method == "HEAD") && !request.upgrade;
  if (harmless || is_stop(request)) return std::nullopt;
  if (!request.origin || !origin_allowed(*request.origin, host)) {
    return refusal(403, messages::origin_wrong, target);
  }
  return std::nullopt;
}

std::uint64_t body_limit(const HttpRequest& request) {
  return is_check(request) || is_scratch(request) ? kMaxProgramBytes : kMaxOtherBody;
}

HttpReply answer(const HttpRequest& request, const RouterData& data) {
  const bool reads = request.method == "GET" || request.method == "HEAD";
  if (!reads) return refusal(405, messages::method_wrong, request.target);
  return request.target.starts_with("/api/") ? api_reply(request, data) : page_reply(request, data);
}

const std::vector<std::pair<std::string_view, std::string_view>>& security_headers() {
  static const std::vector<std::pair<std::string_view, std::string_view>> headers{
      {"Content-Security-Policy",
       "default-src 'none'; script-src 'self'; style-src 'self' 'unsafe-inline'; img-src 'self' data: blob:; "
       "media-src 'self'; connect-src 'self'; font-src 'self'; manifest-src 'self'; frame-ancestors 'none'; "
       "base-uri 'none'; form-action 'self'"},
      {"X-Content-Type-Options", "nosniff"},
      {"Referrer-Policy", "no-referrer"},
      {"Cross-Origin-Resource-Policy", "same-origin"},
  };
  return headers;
}

}  // namespace mirada::server
