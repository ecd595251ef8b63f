(run with: --param 6030=70)
O1(M198: parameter 6030)
M70 P5(expect alarm PS1079)
M30
