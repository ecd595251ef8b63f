O1 (PS0022: an arc needs R or I J K)
G03 X10. Y0 F100 (expect alarm PS0022)
M30
