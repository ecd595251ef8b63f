O1 (PS0119: the root of a negative number)
#100=SQRT[-4] (expect alarm PS0119)
M30
