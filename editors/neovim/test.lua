-- The language server in Neovim without a screen: diagnostics, a fix, formatting, names. Run by editors/test.sh; ASSUR names the program.

local function wait_for(what, holds)
  assert(vim.wait(10000, holds, 20), "waited in vain for " .. what)
end

local folder = vim.fn.tempname()
vim.fn.mkdir(folder, "p")
local path = folder .. "/wrong.mech"
vim.fn.writefile({ "mech 1", "given  φ=5 mm", "lnk crank A-B φ", "ground { A (0, 0) }", "revolute A: ground - crank" }, path)

vim.cmd("edit " .. vim.fn.fnameescape(path))
local buffer = vim.api.nvim_get_current_buf()
local client = vim.lsp.start_client({ name = "assur", cmd = { os.getenv("ASSUR") or "assur", "lsp" }, root_dir = folder })
assert(client, "the server does not start")
vim.lsp.buf_attach_client(buffer, client)

-- an error at its place, with its help
wait_for("diagnostics", function() return #vim.diagnostic.get(buffer) > 0 end)
local found = vim.diagnostic.get(buffer)[1]
assert(found.lnum == 2 and found.col == 0 and found.message:find("help: write: link crank A%-B φ"), vim.inspect(found))

-- its fix
local function ask(method, params)
  local answers = assert(vim.lsp.buf_request_sync(buffer, method, params, 10000), method)
  local answer = assert(answers[client], method)
  assert(not answer.err, vim.inspect(answer))
  return answer.result
end
local document = { uri = vim.uri_from_bufnr(buffer) }
local at = { line = 2, character = 1 }
local actions = ask("textDocument/codeAction", { textDocument = document, range = { start = at, ["end"] = at }, context = { diagnostics = {} } })
assert(actions[1].title == "write: link crank A-B φ", vim.inspect(actions))
vim.lsp.util.apply_workspace_edit(actions[1].edit, "utf-16")
wait_for("the fix", function() return not vim.inspect(vim.diagnostic.get(buffer)):find("lnk") end)

-- formatting
local edits = ask("textDocument/formatting", { textDocument = document, options = { tabSize = 2, insertSpaces = true } })
vim.lsp.util.apply_text_edits(edits, buffer, "utf-16")
local text = table.concat(vim.api.nvim_buf_get_lines(buffer, 0, -1, false), "\n")
assert(text == "mech 1\ngiven φ = 5 mm\nlink crank A-B φ\nground { A (0, 0) }\nrevolute A: ground - crank", text)

-- symbols
local symbols = ask("textDocument/documentSymbol", { textDocument = document })
local names = vim.tbl_map(function(symbol) return symbol.name end, symbols)
assert(vim.deep_equal(names, { "φ", "crank", "ground", "A" }), vim.inspect(names))

-- a name: what it is, where it is declared, another one
local on_use = { textDocument = document, position = { line = 4, character = 22 } }
local hover = ask("textDocument/hover", on_use)
assert(hover.contents.value:find("link crank A%-B φ"), vim.inspect(hover))
local places = ask("textDocument/definition", on_use)
assert(#places == 1 and places[1].range.start.line == 2, vim.inspect(places))
on_use.newName = "handle"
vim.lsp.util.apply_workspace_edit(ask("textDocument/rename", on_use), "utf-16")
text = table.concat(vim.api.nvim_buf_get_lines(buffer, 0, -1, false), "\n")
assert(text:find("link handle A%-B φ") and text:find("ground %- handle"), text)

vim.lsp.stop_client(client)
vim.fn.delete(folder, "rf")
print("neovim: diagnostics, fix, formatting, symbols, hover, definition, rename\n")
vim.cmd("qall!")
