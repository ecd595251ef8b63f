O1 (PS0199: there is no function FOO)
#100=FOO[1] (expect alarm PS0199)
M30
