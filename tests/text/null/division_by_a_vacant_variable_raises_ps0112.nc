O1 (NUL-2: 5/#1)
#100=5/#1 (expect alarm PS0112)
M30
(finally #100=null)
