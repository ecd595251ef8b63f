O1 (PS0112: division by 0)
#100=1/0 (expect alarm PS0112)
M30
(finally #100=null)
