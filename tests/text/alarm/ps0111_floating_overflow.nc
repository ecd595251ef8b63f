O1 (PS0111: beyond the largest double)
#1=POW[10,200]
#100=#1*#1 (expect alarm PS0111)
M30
