print "中文","x"
print "é","x"
' (finally printed 中文      x|é       x|)
