O1 (VAR-1: ##1 is not an indirection)
#1=5
#100=##1 (expect alarm PS0114)
M30
