O1 (PS0032: ten kilometres into a work offset)
#5221=10000000. (expect alarm PS0032)
M30
