O1 (VAR-3: squaring again and again overflows)
#100=1000000
N1 #100=#100*#100 (expect alarm PS0111)
GOTO 1
M30
