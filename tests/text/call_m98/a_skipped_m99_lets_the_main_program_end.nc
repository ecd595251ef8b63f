(run with: --block-skip 1)
O1 (M99-3: the usual way to stop an endless program)
#100=#100+1
/M99
#101=1
M30
(finally #100=1, #101=1)
