O1 (LEX-31: up to three M codes in a block)
M60 M61 M62
M30
(finally records: mcode 60; mcode 61; mcode 62)
