(source_file) @local.scope

(given name: (identifier) @local.definition)
(let name: (identifier) @local.definition)
(load name: (identifier) @local.definition)
(balance name: (identifier) @local.definition)
(link name: (identifier) @local.definition)
(shaft name: (identifier) @local.definition)
(slider name: (identifier) @local.definition)
(pair name: (identifier) @local.definition)
(spring name: (identifier) @local.definition)
(cam name: (identifier) @local.definition)
(curve name: (identifier) @local.definition)
(group name: (identifier) @local.definition)
(event name: (identifier) @local.definition)

[(identifier) (name)] @local.reference
