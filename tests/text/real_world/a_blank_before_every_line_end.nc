% 
O1 (CONTROL DUMP) 
#100=1  (expect #100=1) 
N10 
IF[#100EQ1]GOTO 20 
#101=1 
N20 
G90 G00 X1. (expect moves: rapid X1) 
M30 
(finally #101=null)
% 
