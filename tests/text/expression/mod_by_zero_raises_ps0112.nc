O1 (EXP-8: MOD divides too)
#100=7 MOD 0 (expect alarm PS0112)
M30
