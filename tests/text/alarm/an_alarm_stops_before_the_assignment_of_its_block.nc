O1 (section 13: the variable keeps its value)
#100=5
#100=7/0 (expect alarm PS0112)
M30
(finally #100=5)
