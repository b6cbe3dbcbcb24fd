-- Fixes of files with one mistake each, accepted in Neovim. Run by editors/test.sh in the root of the repository; ASSUR names the program.

local function wait_for(what, holds)
  assert(vim.wait(10000, holds, 20), "waited in vain for " .. what)
end

local count, client = 0, nil
for _, name in ipairs(vim.fn.readfile("editors/fixes.txt")) do
  vim.cmd("edit tests/errors/" .. name .. ".mech")
  local buffer = vim.api.nvim_get_current_buf()
  client = client or vim.lsp.start_client({ name = "assur", cmd = { os.getenv("ASSUR") or "assur", "lsp" }, root_dir = vim.fn.getcwd() })
  vim.lsp.buf_attach_client(buffer, client)
  wait_for(name, function() return #vim.diagnostic.get(buffer) > 0 end)
  local found = vim.diagnostic.get(buffer)[1]
  local at = { line = found.lnum, character = found.col }
  local request = { textDocument = { uri = vim.uri_from_bufnr(buffer) }, range = { start = at, ["end"] = at }, context = { diagnostics = {} } }
  local answer = assert(vim.lsp.buf_request_sync(buffer, "textDocument/codeAction", request, 10000))[client]
  vim.lsp.util.apply_workspace_edit(answer.result[1].edit, "utf-16")
  wait_for("the fix of " .. name, function() return #vim.diagnostic.get(buffer, { severity = vim.diagnostic.severity.ERROR }) == 0 end)
  count = count + 1
  vim.cmd("edit!")
end
assert(count == 10, count)
vim.lsp.stop_client(client)
print("neovim: " .. count .. " fixes\n")
vim.cmd("qall!")
