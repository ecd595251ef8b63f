O1 (the normal form of a label)
IF[#1EQ#0]GOTO1
#100=1
N1
IF[#1NE#0]GOTO2
#101=1
N2
M30
(finally #100=null, #101=1)
