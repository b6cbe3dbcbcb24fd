-- The tree-sitter grammar in Neovim, put there by the lines of README.md. Run by editors/test.sh in the root of the repository.

local lines = table.concat(vim.fn.readfile("editors/neovim/README.md"), "\n")
local folder = vim.fn.tempname()
local said = vim.fn.system("export XDG_CONFIG_HOME=" .. folder .. "\nset -e\n" .. assert(lines:match("```sh\n(.-)\n```")))
assert(vim.v.shell_error == 0, said)
vim.opt.runtimepath:prepend(folder .. "/nvim")

vim.cmd("edit examples/crank-slider.mech")
local tree = vim.treesitter.get_parser(0, "mech"):parse()[1]
assert(not tree:root():has_error(), "an ERROR node")
local query = (vim.treesitter.query.get or vim.treesitter.query.get_query)("mech", "highlights")
local text_of = vim.treesitter.get_node_text or vim.treesitter.query.get_node_text
local found = {}
for id, node in query:iter_captures(tree:root(), 0) do
  found[query.captures[id] .. " " .. text_of(node, 0):match("[^\n]*")] = true
end
for _, wanted in ipairs({ "keyword link", "keyword revolute", "type rod", "type.builtin kg*m^2", "function.builtin inertia_force", "label D" }) do
  assert(found[wanted], wanted .. " is missing: " .. vim.inspect(found))
end
for _, name in ipairs({ "folds", "indents", "locals", "injections" }) do
  assert((vim.treesitter.query.get or vim.treesitter.query.get_query)("mech", name), name)
end
vim.fn.delete(folder, "rf")
print("neovim: colours by tree-sitter\n")
vim.cmd("qall!")
