O1 (section 3.5: ten kilometres are no tool length)
#11001=10000000. (expect alarm PS0032)
M30
