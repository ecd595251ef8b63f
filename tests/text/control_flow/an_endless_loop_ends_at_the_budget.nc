(run with: --max-seconds 1)
O1 (CTL-23: a loop without motion can be interrupted)
#100=1
N1 GOTO 1
M30
(finally status budget)
(finally #100=1)
