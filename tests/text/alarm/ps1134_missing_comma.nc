O1 (PS1134: the arguments of POW stand side by side)
#100=POW[2#1] (expect alarm PS1134 at #)
M30
