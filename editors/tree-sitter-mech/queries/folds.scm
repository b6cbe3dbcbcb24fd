[(body) (properties) (table) (cam)] @fold
(comment)+ @fold
