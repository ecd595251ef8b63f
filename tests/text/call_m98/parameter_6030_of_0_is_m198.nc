(run with: --param 6030=0)
O1(M198: 0 in parameter 6030 is the control's own number, and M00 stays a stop)
M198 P5(expect alarm PS1079)
M30
