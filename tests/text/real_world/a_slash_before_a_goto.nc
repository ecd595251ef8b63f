(run with: --block-skip 1)
O1 (/GOTO4 with the switch on)
/GOTO4
#100=1
N4 M30
(finally #100=1)
