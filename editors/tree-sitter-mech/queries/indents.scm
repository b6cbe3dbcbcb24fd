[(body) (properties) (table) (cam) (parenthesized) (call)] @indent.begin
["}" ")"] @indent.branch @indent.end
