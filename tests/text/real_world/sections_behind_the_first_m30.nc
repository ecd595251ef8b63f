O1 (reached by GOTO, each with its own M30)
#1=2
IF[#1EQ2]GOTO200
#100=1
M30
N200
#101=1
M30
(finally #100=null, #101=1)
