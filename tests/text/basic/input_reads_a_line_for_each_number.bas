' (with input: 12, 2.5)
input "side",s
print "s=";s
input t
print s*t
' (finally printed sides= 12|? 30|)
