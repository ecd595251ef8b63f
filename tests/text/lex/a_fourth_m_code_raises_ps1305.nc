O1 (LEX-31: four are too many)
M60 M61 M62 M63 (expect alarm PS1305)
M30
