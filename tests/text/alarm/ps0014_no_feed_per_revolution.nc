(run with: --param feed_per_revolution=0)
O1 (PS0014: the machine cannot measure its spindle)
G95 G01 X1. F0.1 (expect alarm PS0014 at G95)
M30
