O1 (section 4.2: e to the 1000 is no double)
#100=EXP[1000] (expect alarm PS0119)
M30
