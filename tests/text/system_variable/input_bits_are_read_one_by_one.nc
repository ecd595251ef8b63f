(run with: --set #1003=1)
O1 (section 3.1: #1000 to #1015)
#100=#1003 (expect #100=1)
#101=#1000 (expect #101=0)
IF[#1003EQ1]GOTO 9
M30
N9 #102=1 (expect #102=1)
M30
